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

/// How a saved tree was built. Informative: loading does not depend on it.
struct TreeOrigin {
    std::string method;   ///< name of the build method
    std::string options;  ///< build options as JSON, or any text

    friend bool operator==(const TreeOrigin&, const TreeOrigin&) = default;
};

/// A tree of either kind.
using AnyTree = std::variant<KdTree, Bvh8>;

/// A tree read from a file, and what the file says about it.
struct SavedTree {
    AnyTree tree;                      ///< the tree; it keeps the file mapped
    Fingerprint primitives;            ///< fingerprint of the tree's primitives
    TreeOrigin origin;                 ///< how it was built
    std::uint64_t file_bytes = 0;      ///< size of the file
    std::uint32_t format_version = 0;  ///< version of the file format, see docs/formats.md
};

/// Writes a tree and the fingerprint of its primitives to `file`. Writes to a temporary name,
/// synchronizes it with the disk and renames it, so that `file` is the old file or the whole new
/// one. Equal trees give equal bytes. Throws Error(io).
COPPICE_EXPORT void save_tree(const std::filesystem::path& file, const KdTree& tree,
                              const Fingerprint& primitives, const TreeOrigin& origin = {});
/// Writes an 8-wide tree in the same way.
COPPICE_EXPORT void save_tree(const std::filesystem::path& file, const Bvh8& tree,
                              const Fingerprint& primitives, const TreeOrigin& origin = {});

/// Maps a tree file into memory. Verifies all checksums, and that no query can leave the arrays:
/// indices, ranges, depth and ids. It does not compare the tree with its primitives; validate()
/// does. The tree keeps the mapping alive. Meanwhile the file may be replaced, but must not be
/// modified or truncated. Throws Error: io if the file cannot be read; parse if it is no tree file,
/// truncated or damaged; unsupported if it has another version, byte order or layout.
[[nodiscard]] COPPICE_EXPORT SavedTree load_tree(const std::filesystem::path& file);

/// Maps a tree file that must belong to given primitives. Throws as above, and
/// Error(invalid_argument) if the tree was built for other primitives.
[[nodiscard]] COPPICE_EXPORT SavedTree load_tree(const std::filesystem::path& file,
                                                 const Fingerprint& primitives);

}  // namespace coppice::inline v0
