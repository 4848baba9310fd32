#include "coppice/io/write_file.h"

#include "coppice/base/error.h"

#include "io/new_file.h"

#include <memory>
#include <system_error>
#include <vector>

namespace coppice::inline v0 {

namespace {

namespace fs = std::filesystem;

/// The target of a chain of symbolic links. It need not exist.
fs::path follow_links(fs::path file) {
    constexpr int most_links = 40;  // the limit of Linux
    std::error_code problem;
    for (int i = 0; i < most_links && fs::is_symlink(file, problem); ++i) {
        file = file.parent_path() / fs::read_symlink(file, problem);
    }
    return file;
}

}  // namespace

std::filesystem::path write_target(const std::filesystem::path& file) {
    std::error_code problem;
    const fs::file_status status = fs::status(file, problem);
    if (status.type() == fs::file_type::none) {  // name too long, or a cycle of links
        throw file_error(ErrorCode::io, file.string(), "cannot write: " + problem.message());
    }
    if (fs::is_directory(status)) {
        throw file_error(ErrorCode::io, file.string(), "is a directory, not a file");
    }
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        throw file_error(ErrorCode::io, file.string(), "not a regular file");
    }
    return follow_links(file);
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

}  // namespace coppice::inline v0
