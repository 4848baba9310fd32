#pragma once

#include "coppice/base/memory_meter.h"
#include "coppice/base/parallel.h"
#include "coppice/build/split_finder.h"
#include "coppice/geom/aabb.h"
#include "coppice/tree/kd_node.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coppice {

/// A part of a k-d tree under construction, in KdTree's order: node 0 is its root, and child and
/// reference indices are relative to its own arrays.
struct Subtree {
    std::vector<KdNode> nodes{KdNode{}};
    std::vector<std::uint32_t> references;

    [[nodiscard]] std::uint64_t capacity_bytes() const noexcept {
        return nodes.capacity() * sizeof(KdNode) + references.capacity() * sizeof(std::uint32_t);
    }
};

/// Work on fewer fragments than this is not worth a task of its own.
inline constexpr std::size_t parallel_fragment_count = 4096;

/// Makes node `slot` a leaf that refers to the given fragments. Throws Error(limit) where counts
/// pass what a node can hold.
void make_leaf(Subtree& tree, std::uint32_t slot, std::span<const Fragment> fragments);

/// Makes node `slot` an inner node and appends its two children, empty leaves for now. Returns the
/// lower child's index. Throws Error(limit).
std::uint32_t make_inner(Subtree& tree, std::uint32_t slot, Plane plane, PlanarSide planar_side);

/// Puts a whole subtree in the place of node `slot`; its other nodes and references are appended.
void splice(Subtree& tree, std::uint32_t slot, const Subtree& part);

/// Builds both children of a node, the lower at `lower_slot` and the upper after it, with
/// callables (Subtree&, slot): in place if there are few fragments, else in parallel and spliced.
/// The result is the same. The meter is told of subtrees that wait to be spliced.
template <typename BuildLower, typename BuildUpper>
void build_children(Subtree& tree, std::uint32_t lower_slot, std::size_t fragment_count,
                    BuildLower&& build_lower, BuildUpper&& build_upper,
                    MemoryMeter* meter = nullptr) {
    if (fragment_count < parallel_fragment_count) {
        build_lower(tree, lower_slot);
        build_upper(tree, lower_slot + 1);
        return;
    }
    Subtree lower;
    Subtree upper;
    MeteredBytes lower_bytes;
    MeteredBytes upper_bytes;
    parallel_invoke(
        [&] {
            build_lower(lower, 0U);
            lower_bytes = {meter, lower.capacity_bytes()};
        },
        [&] {
            build_upper(upper, 0U);
            upper_bytes = {meter, upper.capacity_bytes()};
        });
    splice(tree, lower_slot, lower);
    splice(tree, lower_slot + 1, upper);
}

}  // namespace coppice
