#pragma once

#include "coppice/export.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/tree/bvh8.h"
#include "coppice/tree/kd_tree.h"

#include <cstdint>
#include <string>
#include <vector>

namespace coppice::inline v0 {

/// What validate() can find wrong with a tree.
enum class ValidationIssueKind {
    bad_child,              ///< a child index out of range, shared, or not after its parent
    unreachable_node,       ///< a node that no walk from the root meets
    too_deep,               ///< a node below KdTree::max_depth
    plane_outside,          ///< a plane that is not strictly inside its node's box
    bad_range,              ///< a leaf's references reach past the array or overlap another leaf's
    unreachable_reference,  ///< references that belong to no leaf
    bad_reference,          ///< a reference to a primitive that does not exist
    unsorted_references,    ///< a leaf's references are not strictly ascending (or repeat)
    missing_reference,      ///< a primitive reaches into a leaf's inside that does not refer to it
    stray_reference,        ///< a leaf refers to a primitive that does not touch its box
    lost_primitive,         ///< a primitive in no leaf
    bounds_too_small,       ///< a primitive that leaves the tree's box
    box_outside,            ///< an 8-wide node's child box that leaves its parent's
    wrong_corners,          ///< a block whose corners are not those of its triangles
    bad_gap,                ///< an 8-wide node's empty slot before a used one, or with a box
};

/// The stable lower-case name of a kind of finding, e.g. "lost_primitive".
[[nodiscard]] COPPICE_EXPORT const char* finding_name(ValidationIssueKind kind) noexcept;

/// One thing wrong with a tree, in words, with what it is about: the id of a primitive for
/// lost_primitive and bounds_too_small; the index of a reference of a k-d tree for
/// unreachable_reference; the index of a block of an 8-wide tree for unreachable_reference,
/// bad_reference and wrong_corners; else that of a node.
struct ValidationIssue {
    ValidationIssueKind kind;   ///< what is wrong
    std::uint64_t subject = 0;  ///< what it is about, see above
    std::string message;        ///< one line with the numbers in it
};

/// All that is wrong with a tree over `primitives`, at most `limit` findings; none for a sound
/// tree. Cost: one descent of all primitives, O(N log N). Never throws on a malformed tree;
/// throws Error(invalid_argument) for primitives that are not valid (PrimitiveSet).
[[nodiscard]] COPPICE_EXPORT std::vector<ValidationIssue> validate(const KdTree& tree,
                                                                   PrimitiveSetView primitives,
                                                                   std::size_t limit = 100);

/// The same for an 8-wide tree over the triangles of `mesh`. A triangle counts as lost unless its
/// corners and the middle of its edges each lie in the box of a leaf that refers to it.
[[nodiscard]] COPPICE_EXPORT std::vector<ValidationIssue> validate(const Bvh8& tree,
                                                                   TriangleMeshView mesh,
                                                                   std::size_t limit = 100);

}  // namespace coppice::inline v0
