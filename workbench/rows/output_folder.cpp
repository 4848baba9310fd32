#include "rows/output_folder.h"

#include "coppice/base/error.h"
#include "coppice/io/write_file.h"

#include <array>
#include <cstdlib>
#include <system_error>
#include <vector>

namespace coppice::lab {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what, std::error_code reason) {
    throw file_error(ErrorCode::io, path.string(), what + ": " + reason.message());
}

/// Makes a folder and those above it that are missing; removes them again at the end of its life,
/// as far as they are empty, unless kept.
class MadeFolders {
public:
    explicit MadeFolders(const fs::path& folder) {
        std::vector<fs::path> missing;
        std::error_code error;
        for (fs::path path = folder; !path.empty() && !fs::exists(path, error);
             path = path.parent_path()) {
            missing.push_back(path);
        }
        for (auto path = missing.rbegin(); path != missing.rend(); ++path) {
            if (fs::create_directory(*path, error)) made_.push_back(*path);
            if (error) {
                remove();
                fail(*path, "cannot make the folder", error);
            }
        }
        if (!fs::is_directory(folder, error)) {
            throw file_error(ErrorCode::io, folder.string(), "is not a folder");
        }
    }

    MadeFolders(const MadeFolders&) = delete;
    MadeFolders& operator=(const MadeFolders&) = delete;

    ~MadeFolders() { remove(); }

    void keep() noexcept { made_.clear(); }

private:
    void remove() noexcept {
        std::error_code ignored;
        for (auto path = made_.rbegin(); path != made_.rend(); ++path) {
            fs::remove(*path, ignored);
        }
        made_.clear();
    }

    std::vector<fs::path> made_;
};

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Makes sure that a file can be made in a folder; leaves none.
void require_writable(const fs::path& folder) {
    std::string name = (folder / ".coppice-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        fail(folder, "cannot write to the folder", {errno, std::generic_category()});
    }
    std::error_code ignored;
    fs::remove(name, ignored);
}

}  // namespace

void check_writable(const fs::path& folder, std::span<const std::string_view> names) {
    const MadeFolders made(folder);
    require_writable(folder);
    for (const std::string_view name : names) {
        static_cast<void>(write_target(folder / name));
    }
}

void check_file_writable(const fs::path& file) {
    std::error_code error;
    const fs::path folder = folder_of(write_target(file));
    const bool is_there = fs::exists(folder, error);
    if (error) fail(file, "cannot write the file", error);
    if (!is_there) {
        throw file_error(ErrorCode::io, file.string(),
                         "cannot write the file: make this folder first: " + folder.string());
    }
    require_writable(folder);
}

void write_all(const fs::path& folder, std::span<const OutputFile> files) {
    MadeFolders made(folder);
    std::vector<FileContents> contents;
    for (const OutputFile& file : files) {
        contents.push_back({folder / file.name, file.contents});
    }
    write_files(contents);
    made.keep();
}

}  // namespace coppice::lab
