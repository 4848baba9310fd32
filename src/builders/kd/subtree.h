#pragma once

#include "coppice/builders/split_finder.h"
#include "coppice/geom/aabb.h"
#include "coppice/tree/kd_node.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// A part of a k-d tree under construction, in KdTree's order. Node 0 is its root. Child and
/// reference indices are relative to its own arrays.
struct Subtree {
    std::vector<KdNode> nodes{KdNode{}};
    std::vector<std::uint32_t> references;

    /// The capacity of both arrays in bytes.
    [[nodiscard]] std::uint64_t capacity_bytes() const noexcept {
        return nodes.capacity() * sizeof(KdNode) + references.capacity() * sizeof(std::uint32_t);
    }
};

/// Makes node `slot` a leaf of the given PrimRefs. Throws Error(limit) if counts exceed what a node
/// can hold.
void make_leaf(Subtree& tree, std::uint32_t slot, std::span<const PrimRef> prim_refs);

/// Makes node `slot` an inner node and appends its two children as empty leaves. Returns the index
/// of the lower child. Throws Error(limit) if there are too many nodes.
std::uint32_t make_inner(Subtree& tree, std::uint32_t slot, SplitPlane plane,
                         PlanarSide planar_side);

/// The node with its indices increased by the given numbers of nodes and references.
[[nodiscard]] KdNode relocated(const KdNode& node, std::uint32_t node_offset,
                               std::uint32_t reference_offset) noexcept;

/// Throws Error(limit) if a tree cannot have this many nodes or references.
void require_possible(std::uint64_t node_count, std::uint64_t reference_count);

}  // namespace coppice::inline v0
