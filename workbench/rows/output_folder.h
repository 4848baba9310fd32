#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace coppice::lab {

/// A file to be written into a folder.
struct OutputFile {
    std::string name;
    std::string contents;
};

/// Makes sure that files of these names can be written into a folder, made if need be; leaves no
/// trace. Throws Error(io) saying why not.
void check_writable(const std::filesystem::path& folder, std::span<const std::string_view> names);

/// Makes sure that one file can be written, into a folder that is there; leaves no trace. Throws
/// Error(io) saying why not.
void check_file_writable(const std::filesystem::path& file);

/// Writes all files into a folder, made if need be: all of them or none. Each replaces its
/// predecessor at once. Throws Error(io).
void write_all(const std::filesystem::path& folder, std::span<const OutputFile> files);

}  // namespace coppice::lab
