#pragma once

#include "coppice/export.h"

#include <filesystem>
#include <span>
#include <string_view>

namespace coppice::inline v0 {

/// Writes `contents` to a temporary name beside `file`, then renames it to `file`. Readers see the
/// old file or the whole new one. Throws Error(io) if that fails; no temporary file remains.
COPPICE_EXPORT void write_file(const std::filesystem::path& file, std::string_view contents);

/// A file to write, with its contents.
struct FileContents {
    std::filesystem::path file;  ///< path of the file
    std::string_view contents;   ///< all bytes of the file
};

/// Writes several files as write_file() does. None is renamed before all are written. Throws
/// Error(io).
COPPICE_EXPORT void write_files(std::span<const FileContents> files);

/// Returns the file that writing to `file` creates or replaces: the target of a symbolic link,
/// otherwise `file` itself. Throws Error(io) if that exists and is no regular file: a folder, or a
/// device or pipe, which the rename would replace.
[[nodiscard]] COPPICE_EXPORT std::filesystem::path write_target(const std::filesystem::path& file);

}  // namespace coppice::inline v0
