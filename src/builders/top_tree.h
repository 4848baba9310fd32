#pragma once

#include "coppice/tree/kd_node.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// The upper part of a tree, chosen from a sample. Its leaves are cells, each of which is grown as
/// one unit. Primitives descend it many levels at once.
class TopTree {
public:
    /// A node: a plane between two children, or a cell.
    struct Node {
        SplitPlane plane{};
        std::uint32_t index =
            0;  ///< index of the lower child (the upper one follows), or of the cell
        PlanarSide planar_side = PlanarSide::below;
        bool is_cell = true;
    };

    /// The direction in which a descent continues from a node.
    enum class Step : std::uint8_t { below, above, nowhere };

    /// A tree of one cell.
    TopTree() : nodes_(1) {}

    /// All nodes: the root first, children after their parents.
    [[nodiscard]] std::span<const Node> nodes() const noexcept { return nodes_; }

    [[nodiscard]] std::size_t cell_count() const noexcept { return cell_count_; }

    /// Replaces a cell by a plane with two cells, which are not numbered yet. Returns the index of
    /// the lower one.
    std::uint32_t split(std::uint32_t node, SplitPlane plane, PlanarSide planar_side);

    /// Numbers the cells, depth first.
    void number_cells();

    /// Descends from the root as `step(node)` says, and returns the node where that ends: a cell,
    /// or the node where the step is `nowhere`.
    template <typename Lead>
    [[nodiscard]] std::uint32_t descend(std::uint32_t node, Lead&& step) const noexcept {
        while (!nodes_[node].is_cell) {
            const Step next = step(nodes_[node]);
            if (next == Step::nowhere) break;
            node = nodes_[node].index + (next == Step::above ? 1U : 0U);
        }
        return node;
    }

private:
    std::vector<Node> nodes_;
    std::uint32_t cell_count_ = 1;
};

}  // namespace coppice::inline v0
