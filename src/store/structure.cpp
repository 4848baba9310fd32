// Checks that a tree is safe to query. Nodes are checked as in validate() (tree/shape.h).
// References and blocks are checked in parallel, since there are many. Lanes without a triangle
// must satisfy what traversals rely on: they come last, and their corners are NaN, which no ray
// hits.

#include "store/structure.h"

#include "coppice/base/parallel.h"

#include "tree/issue_list.h"
#include "tree/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>

namespace coppice::inline v0 {
namespace {

/// Bounds must be finite or the empty box, because searches scale distances by them. Returns "" if
/// they are.
std::string find_bounds_flaw(const Aabb& bounds) {
    const bool is_sound = bounds == Aabb{} || (bounds.is_finite() && !bounds.is_empty());
    return is_sound ? "" : "its bounds are not a finite box";
}

/// The first of `count` items for which `is_sound` is false, or `count`.
template <typename IsSound>
std::size_t find_first(std::size_t count, const IsSound& is_sound) {
    constexpr std::size_t chunk = 4096;
    std::atomic<std::size_t> first{count};
    parallel_for_chunks(count, chunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t at = begin; at < end; ++at) {
            if (is_sound(at)) continue;
            std::size_t known = first.load();
            while (at < known && !first.compare_exchange_weak(known, at)) {
            }
            return;
        }
    });
    return first;
}

// True if every lane holds an existing triangle, or all lanes after it are empty and have NaN
// corners.
bool is_sound(const TriangleBlock& block, std::uint32_t primitive_count) {
    bool is_gap = false;
    for (std::size_t lane = 0; lane < bvh8_width; ++lane) {
        if (block.id[lane] == TriangleBlock::no_triangle) {
            is_gap = true;
            if (!std::isnan(block.corner[0][0][lane])) return false;
        } else if (is_gap || block.id[lane] >= primitive_count) {
            return false;
        }
    }
    return true;
}

template <typename Tree>
std::string find_shape_flaw(const Tree& tree) {
    if (std::string flaw = find_bounds_flaw(tree.bounds()); !flaw.empty()) return flaw;
    IssueList first(1);
    check_shape(tree, first);
    return first.is_empty() ? "" : first.first_message();
}

}  // namespace

std::string find_flaw(const KdTree& tree, std::uint32_t primitive_count) {
    if (std::string flaw = find_shape_flaw(tree); !flaw.empty()) return flaw;
    const auto references = tree.references();
    const std::size_t bad = find_first(
        references.size(), [&](std::size_t at) { return references[at] < primitive_count; });
    if (bad == references.size()) return {};
    return fmt::format("reference {} is to primitive {}, but there are {} primitives", bad,
                       references[bad], primitive_count);
}

std::string find_flaw(const Bvh8& tree, std::uint32_t primitive_count) {
    if (std::string flaw = find_shape_flaw(tree); !flaw.empty()) return flaw;
    const auto blocks = tree.blocks();
    const std::size_t bad = find_first(
        blocks.size(), [&](std::size_t at) { return is_sound(blocks[at], primitive_count); });
    if (bad == blocks.size()) return {};
    return fmt::format("block {} has a gap, or a triangle id out of range ({} triangles)", bad,
                       primitive_count);
}

}  // namespace coppice::inline v0
