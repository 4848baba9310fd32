#pragma once

#include <filesystem>
#include <string_view>

namespace coppice {

/// Writes `contents` to a temporary name beside `file`, then renames it over `file`: readers see
/// the old file or the whole new one. Throws Error(io), and leaves no temporary file behind.
void write_file(const std::filesystem::path& file, std::string_view contents);

}  // namespace coppice
