#include "lab/output_folder.h"

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

/// A new folder inside another, removed with all that is in it at the end of its life.
class StagingFolder {
public:
    explicit StagingFolder(const fs::path& parent) {
        std::string name = (parent / ".coppice-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            fail(parent, "cannot write to the folder", {errno, std::generic_category()});
        }
        path_ = name;
    }

    StagingFolder(const StagingFolder&) = delete;
    StagingFolder& operator=(const StagingFolder&) = delete;

    ~StagingFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }

    [[nodiscard]] const fs::path& path() const noexcept { return path_; }

private:
    fs::path path_;
};

}  // namespace

void check_writable(const fs::path& folder, std::span<const std::string_view> names) {
    const MadeFolders made(folder);
    const StagingFolder probe(folder);
    std::error_code ignored;
    for (const std::string_view name : names) {
        if (fs::is_directory(folder / name, ignored)) {
            throw file_error(ErrorCode::io, (folder / name).string(),
                             "is a folder where a file is to be written");
        }
    }
}

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

void check_file_writable(const fs::path& file) {
    std::error_code error;
    const fs::path folder = folder_of(file);
    const bool is_there = fs::exists(folder, error);
    if (error) fail(file, "cannot write the file", error);
    if (!is_there) {
        throw file_error(ErrorCode::io, file.string(),
                         "cannot write the file: there is no folder " + folder.string());
    }
    const std::string name = file.filename().string();
    check_writable(folder, std::array{std::string_view(name)});
}

void write_all(const fs::path& folder, std::span<const OutputFile> files) {
    MadeFolders made(folder);
    {
        const StagingFolder staging(folder);
        for (const OutputFile& file : files) {
            write_file(staging.path() / file.name, file.contents);
        }
        for (const OutputFile& file : files) {
            std::error_code error;
            fs::rename(staging.path() / file.name, folder / file.name, error);
            if (error) fail(folder / file.name, "cannot write the file", error);
        }
    }
    made.keep();
}

}  // namespace coppice::lab
