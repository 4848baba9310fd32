#pragma once

#include "coppice/export.h"
#include "coppice/store/fingerprint.h"
#include "coppice/tree/bvh8.h"
#include "coppice/tree/kd_tree.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>

namespace coppice::inline v0 {

/// How a saved tree was built, for those who read it: its loading does not depend on it.
struct TreeOrigin {
    std::string method;   ///< its name
    std::string options;  ///< as JSON, or what you like

    friend bool operator==(const TreeOrigin&, const TreeOrigin&) = default;
};

/// A tree of either kind.
using AnyTree = std::variant<KdTree, Bvh8>;

/// A tree that was read from a file, with what the file says of it.
struct SavedTree {
    AnyTree tree;                      ///< keeps the file mapped
    Fingerprint primitives;            ///< what the tree was built for
    TreeOrigin origin;                 ///< how it was built
    std::uint64_t file_bytes = 0;      ///< size of the file
    std::uint32_t format_version = 0;  ///< of the file, see docs/formats.md
};

/// Writes a tree and the fingerprint of its primitives to a file: under a temporary name, which is
/// synchronized with the disk and then renamed, so that `file` is the old one or the whole new one.
/// The same tree gives the same bytes. Throws Error(io).
COPPICE_EXPORT void save_tree(const std::filesystem::path& file, const KdTree& tree,
                              const Fingerprint& primitives, const TreeOrigin& origin = {});
/// The same for an 8-wide tree.
COPPICE_EXPORT void save_tree(const std::filesystem::path& file, const Bvh8& tree,
                              const Fingerprint& primitives, const TreeOrigin& origin = {});

/// Maps a tree file into memory, verifies all checksums, and that no query can leave the arrays
/// whatever they hold: indices, ranges, depth, ids. The tree keeps the mapping alive; the file may
/// be replaced meanwhile, but not be written into or cut short. Throws Error: io if it cannot be
/// read; parse if it is no tree file, truncated or damaged; unsupported if it is of another
/// version, byte order or layout. What it does not do is compare the tree with its primitives:
/// validate() does.
[[nodiscard]] COPPICE_EXPORT SavedTree load_tree(const std::filesystem::path& file);

/// The same for given primitives. Throws Error(invalid_argument), too, if the tree was built for
/// others.
[[nodiscard]] COPPICE_EXPORT SavedTree load_tree(const std::filesystem::path& file,
                                                 const Fingerprint& primitives);

}  // namespace coppice::inline v0
