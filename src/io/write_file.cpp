#include "coppice/io/write_file.h"

#include "coppice/base/error.h"

#include "io/new_file.h"

#include <memory>
#include <system_error>
#include <vector>

namespace coppice {

std::filesystem::path write_target(const std::filesystem::path& file) {
    namespace fs = std::filesystem;
    std::error_code problem;
    fs::path target = fs::is_symlink(file, problem) ? fs::weakly_canonical(file, problem) : file;
    const fs::file_status status = fs::status(target, problem);
    if (status.type() == fs::file_type::none) {  // such as of a name that is too long
        throw file_error(ErrorCode::io, file.string(), "cannot write: " + problem.message());
    }
    if (fs::is_directory(status)) throw file_error(ErrorCode::io, file.string(), "is a directory");
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        throw file_error(ErrorCode::io, file.string(), "not a regular file");
    }
    return target;
}

void write_file(const std::filesystem::path& file, std::string_view contents) {
    NewFile output(file);
    output.write(contents);
    output.commit();
}

void write_files(std::span<const FileContents> files) {
    std::vector<std::unique_ptr<NewFile>> outputs;
    for (const FileContents& each : files) {
        outputs.push_back(std::make_unique<NewFile>(each.file));
        outputs.back()->write(each.contents);
        outputs.back()->close();
    }
    for (const auto& output : outputs) {
        output->commit();
    }
}

}  // namespace coppice
