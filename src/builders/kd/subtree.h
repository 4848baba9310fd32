#pragma once

#include "coppice/builders/split_finder.h"
#include "coppice/geom/aabb.h"
#include "coppice/tree/kd_node.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// A part of a k-d tree under construction, in KdTree's order: node 0 is its root, and child and
/// reference indices are relative to its own arrays.
struct Subtree {
    std::vector<KdNode> nodes{KdNode{}};
    std::vector<std::uint32_t> references;

    /// What both arrays have allocated.
    [[nodiscard]] std::uint64_t capacity_bytes() const noexcept {
        return nodes.capacity() * sizeof(KdNode) + references.capacity() * sizeof(std::uint32_t);
    }
};

/// Makes node `slot` a leaf that refers to the given PrimRefs. Throws Error(limit) where counts
/// pass what a node can hold.
void make_leaf(Subtree& tree, std::uint32_t slot, std::span<const PrimRef> prim_refs);

/// Makes node `slot` an inner node and appends its two children, empty leaves for now. Returns the
/// lower child's index. Throws Error(limit).
std::uint32_t make_inner(Subtree& tree, std::uint32_t slot, SplitPlane plane,
                         PlanarSide planar_side);

/// The node as it is once its arrays have moved on by so many nodes and references.
[[nodiscard]] KdNode relocated(const KdNode& node, std::uint32_t node_offset,
                               std::uint32_t reference_offset) noexcept;

/// Throws Error(limit) if a tree cannot have so many nodes or references.
void require_possible(std::uint64_t node_count, std::uint64_t reference_count);

}  // namespace coppice::inline v0
