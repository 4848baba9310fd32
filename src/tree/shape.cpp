// Each child must follow its parent and have no other parent. So one pass in order knows the depth
// of every node before it reaches it, and every walk terminates. Empty slots must satisfy what
// traversals rely on: they come last, and their boxes are empty.

#include "tree/shape.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace coppice::inline v0 {
namespace {

class ShapeCheck {
public:
    ShapeCheck(std::size_t node_count, int max_depth, IssueList& issues)
        : depths_(node_count, unknown), max_depth_(max_depth), issues_(issues) {
        depths_[0] = 0;
    }

    // Call it for each node in order. Returns false if the node is too deep; the check then ends,
    // because one report suffices.
    bool enter(std::size_t node) {
        std::uint8_t& depth = depths_[node];
        if (depth == unknown) {
            issues_.report(ValidationIssueKind::unreachable_node, node, "node {} has no parent",
                           node);
            depth = 0;  // its descendants have a parent
        }
        if (depth <= max_depth_) return true;
        issues_.report(ValidationIssueKind::too_deep, node, "node {} is more than {} levels deep",
                       node, max_depth_);
        return false;
    }

    void add_child(std::size_t parent, std::size_t child) {
        if (child > parent && child < depths_.size() && depths_[child] == unknown) {
            depths_[child] = static_cast<std::uint8_t>(depths_[parent] + 1);
            return;
        }
        issues_.report(ValidationIssueKind::bad_child, parent,
                       "node {} has the child {} of {} nodes: out of range, not after its parent, "
                       "or already used by another node",
                       parent, child, depths_.size());
    }

    // Checks a leaf of items [first, first + count).
    void add_leaf(std::size_t node, std::uint64_t first, std::uint64_t count,
                  std::uint64_t item_count, std::string_view items) {
        if (first + count <= item_count) return;
        issues_.report(ValidationIssueKind::bad_range, node,
                       "a leaf of node {} has {} {} to {} of {}", node, items, first, first + count,
                       item_count);
    }

private:
    static constexpr std::uint8_t unknown = 0xff;
    static_assert(KdTree::max_depth < unknown - 1 && Bvh8::max_depth < unknown - 1);

    std::vector<std::uint8_t> depths_;  // of each node, set when its parent is visited
    int max_depth_;
    IssueList& issues_;
};

bool has_empty_box(const Bvh8Node& node, std::size_t slot) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (std::size_t row = 0; row < node.bound.size(); ++row) {
        if (node.bound[row][slot] != (row < 3 ? infinity : -infinity)) return false;
    }
    return true;
}

bool has_sound_gaps(const Bvh8Node& node) {
    bool is_gap = false;
    for (std::size_t slot = 0; slot < bvh8_width; ++slot) {
        if (!node.child[slot].is_empty()) {
            if (is_gap) return false;
        } else {
            is_gap = true;
            if (!has_empty_box(node, slot)) return false;
        }
    }
    return true;
}

}  // namespace

void check_shape(const KdTree& tree, IssueList& issues) {
    const auto nodes = tree.nodes();
    ShapeCheck check(nodes.size(), KdTree::max_depth, issues);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const KdNode node = nodes[i];
        if (!check.enter(i)) return;
        if (node.is_leaf()) {
            check.add_leaf(i, node.first_reference(), node.reference_count(),
                           tree.references().size(), "references");
        } else {
            check.add_child(i, node.lower_child());
            check.add_child(i, node.upper_child());
        }
    }
}

void check_shape(const Bvh8& tree, IssueList& issues) {
    const auto nodes = tree.nodes();
    ShapeCheck check(nodes.size(), Bvh8::max_depth, issues);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!check.enter(i)) return;
        if (!has_sound_gaps(nodes[i])) {
            issues.report(ValidationIssueKind::bad_gap, i,
                          "node {} has an empty slot before a used one, or one with a box", i);
        }
        for (const Bvh8Child child : nodes[i].child) {
            if (child.is_empty()) continue;
            if (child.is_leaf()) {
                check.add_leaf(i, child.first_block(), child.block_count(), tree.blocks().size(),
                               "blocks");
            } else {
                check.add_child(i, child.node());
            }
        }
    }
}

}  // namespace coppice::inline v0
