#pragma once

#include "coppice/geom/triangle_mesh.h"
#include "coppice/store/tree_file.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace coppice::app {

/// --tree FILE.
void add_tree(CLI::App& parser, std::string& tree);

/// With --tree given: throws UsageError for an option that says how a tree is to be built, and for
/// a second scene.
void check_tree_arguments(const CLI::App& parser, const std::string& tree,
                          std::span<const std::string> scenes);

/// "k-d tree" or "8-wide tree".
[[nodiscard]] std::string_view kind_name(const AnyTree& tree) noexcept;

/// Finds out whether a tree can be written to `file`, before any work. Throws UsageError if it is
/// the scene itself, Error(io) if it cannot be written.
void check_tree_output(const std::string& file, const std::filesystem::path& scene);

}  // namespace coppice::app
