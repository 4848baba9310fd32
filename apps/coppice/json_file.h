#pragma once

#include "output.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace coppice::app {

/// Throws UsageError if no file is named, and Error(io) if it cannot be written: before any work.
void check_json_file(const std::filesystem::path& file);

/// Writes a document, whole or not at all, and prints that. Throws Error(io).
void write_json_file(const std::filesystem::path& file, const nlohmann::ordered_json& document,
                     Output& output);

}  // namespace coppice::app
