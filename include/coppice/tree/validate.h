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

/// The kinds of faults that validate() finds.
enum class ValidationIssueKind {
    bad_child,              ///< a child index out of range, shared, or not after its parent
    unreachable_node,       ///< a node that no walk from the root meets
    too_deep,               ///< a node below KdTree::max_depth
    plane_outside,          ///< a plane that is not strictly inside its node's box
    bad_range,              ///< a leaf's references reach past the array or overlap another leaf's
    unreachable_reference,  ///< references that belong to no leaf
    bad_reference,          ///< a reference to a primitive that does not exist
    unsorted_references,    ///< a leaf's references are not strictly ascending (or repeat)
    missing_reference,      ///< a leaf lacks a primitive that reaches into its interior
    stray_reference,        ///< a leaf refers to a primitive that does not touch its box
    lost_primitive,         ///< a primitive in no leaf
    bounds_too_small,       ///< a primitive that extends beyond the tree's box
    box_outside,            ///< an 8-wide node's child box that extends beyond its parent's
    wrong_corners,          ///< a block whose corners differ from those of its triangles
    bad_gap,                ///< an 8-wide node's empty slot before a used one, or with a box
};

/// The stable lower-case name of a kind of issue, e.g. "lost_primitive".
[[nodiscard]] COPPICE_EXPORT const char* name_of(ValidationIssueKind kind) noexcept;

/// One fault of a tree. `subject` is the index of a node, with these exceptions: the id of a
/// primitive for lost_primitive and bounds_too_small; the index of a reference for
/// unreachable_reference in a k-d tree; the index of a block for unreachable_reference,
/// bad_reference and wrong_corners in an 8-wide tree.
struct ValidationIssue {
    ValidationIssueKind kind;   ///< the kind of fault
    std::uint64_t subject = 0;  ///< what is at fault, see above
    std::string message;        ///< one line that states the fault with its numbers
};

/// Returns the faults of a tree over `primitives`, at most `limit` of them; empty for a sound tree.
/// Never throws on a malformed tree. Throws Error(invalid_argument) for invalid primitives
/// (PrimitiveSet). Cost: one descent of all primitives, O(N log N).
[[nodiscard]] COPPICE_EXPORT std::vector<ValidationIssue> validate(const KdTree& tree,
                                                                   PrimitiveSetView primitives,
                                                                   std::size_t limit = 100);

/// Returns the faults of an 8-wide tree over the triangles of `mesh`. A triangle counts as lost
/// unless each of its corners and edge midpoints lies in the box of a leaf that refers to the
/// triangle.
[[nodiscard]] COPPICE_EXPORT std::vector<ValidationIssue> validate(const Bvh8& tree,
                                                                   TriangleMeshView mesh,
                                                                   std::size_t limit = 100);

}  // namespace coppice::inline v0
