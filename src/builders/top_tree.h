#pragma once

#include "coppice/tree/kd_node.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// The upper part of a tree, chosen from a sample: planes down to cells, each of which is grown as
/// one unit. Primitives go down it many levels at once.
class TopTree {
public:
    /// A plane between two children, or a cell.
    struct Node {
        SplitPlane plane{};
        std::uint32_t index =
            0;  ///< of the lower child, which the upper one follows; or of the cell
        PlanarSide planar_side = PlanarSide::below;
        bool is_cell = true;
    };

    /// Where something goes from a node.
    enum class Step : std::uint8_t { below, above, nowhere };

    /// One cell.
    TopTree() : nodes_(1) {}

    /// The root first, children after their parents.
    [[nodiscard]] std::span<const Node> nodes() const noexcept { return nodes_; }

    [[nodiscard]] std::size_t cell_count() const noexcept { return cell_count_; }

    /// Puts a plane in a cell's place and returns the lower of two cells below it, of which none
    /// has a number yet.
    std::uint32_t split(std::uint32_t node, SplitPlane plane, PlanarSide planar_side);

    /// Gives cells their numbers, depth first.
    void number_cells();

    /// The node at which something ends that `step(node)` leads from one plane to the next: a cell,
    /// or where it goes nowhere.
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
