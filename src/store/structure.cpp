// Children come after their parents and have one each, so that one pass in order knows the depth of
// every node before it is met, and walks end. What is asked of slots and lanes that hold nothing is
// what traversals rely on: they come last, no ray meets their box, no ray hits their corners.

#include "store/structure.h"

#include "coppice/base/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace coppice::inline v0 {
namespace {

constexpr std::uint8_t unknown = 0xff;

// The depths of nodes that have been met as children.
class Depths {
public:
    explicit Depths(std::size_t node_count) : depths_(node_count, unknown) { depths_[0] = 0; }

    /// False if `child` is not after `parent`, does not exist, or is another's.
    bool hang(std::size_t child, std::size_t parent) {
        if (child <= parent || child >= depths_.size() || depths_[child] != unknown) return false;
        depths_[child] = static_cast<std::uint8_t>(depths_[parent] + 1);
        return true;
    }

    [[nodiscard]] std::uint8_t of(std::size_t node) const { return depths_[node]; }

private:
    std::vector<std::uint8_t> depths_;
};

static_assert(KdTree::max_depth < unknown - 1 && Bvh8::max_depth < unknown - 1);

std::string bad_depth(std::size_t node, std::uint8_t depth, int most) {
    if (depth == unknown) return fmt::format("node {} is nobody's child", node);
    return fmt::format("node {} is more than {} levels deep", node, most);
}

std::string bad_child(std::size_t node, std::uint64_t child, std::size_t count) {
    return fmt::format("node {} has the child {} of {} nodes, which is none or another's", node,
                       child, count);
}

/// Finite, or those of nothing: searches scale distances by them. Empty text if they are.
std::string find_bounds_flaw(const Aabb& bounds) {
    const bool is_sound = bounds == Aabb{} || (bounds.is_finite() && !bounds.is_empty());
    return is_sound ? "" : "its bounds are no finite box";
}

/// The first of `count` things that is not as it should be, or `count`.
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

// Slots that hold nothing come last and have the empty box.
bool has_sound_gaps(const Bvh8Node& node) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    bool is_gap = false;
    for (std::size_t slot = 0; slot < bvh8_width; ++slot) {
        if (!node.child[slot].is_empty()) {
            if (is_gap) return false;
            continue;
        }
        is_gap = true;
        for (std::size_t row = 0; row < node.bound.size(); ++row) {
            if (node.bound[row][slot] != (row < 3 ? infinity : -infinity)) return false;
        }
    }
    return true;
}

// Lanes hold a triangle that exists, or come last and have a corner of NaN.
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

std::string find_node_flaw(const Bvh8& tree) {
    const auto nodes = tree.nodes();
    Depths depths(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (depths.of(i) > Bvh8::max_depth) {
            return bad_depth(i, depths.of(i), Bvh8::max_depth);
        }
        if (!has_sound_gaps(nodes[i])) return fmt::format("node {} has a hole", i);
        for (const Bvh8Child child : nodes[i].child) {
            if (child.is_empty()) break;
            if (!child.is_leaf()) {
                if (!depths.hang(child.node(), i)) return bad_child(i, child.node(), nodes.size());
                continue;
            }
            const std::uint64_t end = std::uint64_t{child.first_block()} + child.block_count();
            if (end > tree.blocks().size()) {
                return fmt::format("a leaf of node {} has blocks {} to {} of {}", i,
                                   child.first_block(), end, tree.blocks().size());
            }
        }
    }
    return {};
}

}  // namespace

std::string find_flaw(const KdTree& tree, std::uint32_t primitive_count) {
    if (std::string flaw = find_bounds_flaw(tree.bounds()); !flaw.empty()) return flaw;
    const auto nodes = tree.nodes();
    const auto references = tree.references();
    Depths depths(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const KdNode node = nodes[i];
        if (depths.of(i) > KdTree::max_depth) return bad_depth(i, depths.of(i), KdTree::max_depth);
        if (!node.is_leaf()) {
            const bool is_sound =
                depths.hang(node.lower_child(), i) && depths.hang(node.upper_child(), i);
            if (!is_sound) return bad_child(i, node.lower_child(), nodes.size());
        } else if (std::uint64_t{node.first_reference()} + node.reference_count() >
                   references.size()) {
            return fmt::format("leaf {} has {} references from {} on, of {}", i,
                               node.reference_count(), node.first_reference(), references.size());
        }
    }
    const std::size_t bad = find_first(
        references.size(), [&](std::size_t at) { return references[at] < primitive_count; });
    if (bad == references.size()) return {};
    return fmt::format("reference {} is to primitive {} of {}", bad, references[bad],
                       primitive_count);
}

std::string find_flaw(const Bvh8& tree, std::uint32_t primitive_count) {
    if (std::string flaw = find_bounds_flaw(tree.bounds()); !flaw.empty()) return flaw;
    if (std::string flaw = find_node_flaw(tree); !flaw.empty()) return flaw;
    const auto blocks = tree.blocks();
    const std::size_t bad = find_first(
        blocks.size(), [&](std::size_t at) { return is_sound(blocks[at], primitive_count); });
    if (bad == blocks.size()) return {};
    return fmt::format("block {} has a hole or a triangle that is none of {}", bad,
                       primitive_count);
}

}  // namespace coppice::inline v0
