#pragma once

#include "coppice/export.h"

#include <filesystem>
#include <span>
#include <string_view>

namespace coppice::inline v0 {

/// Writes `contents` to a temporary name beside `file`, then renames it over `file`: readers see
/// the old file or the whole new one. Throws Error(io), and leaves no temporary file behind.
COPPICE_EXPORT void write_file(const std::filesystem::path& file, std::string_view contents);

/// What is to be in a file.
struct FileContents {
    std::filesystem::path file;  ///< its path
    std::string_view contents;   ///< all of its bytes
};

/// The same with several files: only when all are written are they renamed. Throws Error(io).
COPPICE_EXPORT void write_files(std::span<const FileContents> files);

/// The file that writing to `file` makes or replaces: what it links to, or itself. Throws Error(io)
/// if there is anything but a regular file: a folder, or a device or pipe, which the rename would
/// replace.
[[nodiscard]] COPPICE_EXPORT std::filesystem::path write_target(const std::filesystem::path& file);

}  // namespace coppice::inline v0
