#pragma once

#include "coppice/tree/kd_node.h"

#include "builders/kd/partition.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// The upper part of a tree, as far down as PrimRefs are sent at once. What it ends at are cells.
class TopTree {
public:
    /// A node of the tree, its box and its depth.
    struct Cell {
        std::uint32_t index;
        Aabb box;
        int depth;
    };

    /// An inner node of the top_tree, or a cell.
    struct Node {
        static constexpr std::uint32_t is_cell = ~0U;

        SplitPlane plane;
        PlanarSide planar_side;
        std::uint32_t lower;  ///< is_cell, or the lower child; the upper one follows it
        std::uint32_t cell;
    };

    /// The nodes below `root` down to leaves, to those that `ends_at(index)`, and to `level_count`
    /// levels.
    TopTree(std::span<const KdNode> tree, const Cell& root, int level_count,
            const std::function<bool(std::uint32_t)>& ends_at);

    /// The root first, children after their parents.
    [[nodiscard]] std::span<const Node> nodes() const noexcept { return nodes_; }

    /// In depth-first order.
    [[nodiscard]] std::span<const Cell> cells() const noexcept { return cells_; }

    /// The PrimRefs of every cell, each in the order of the root's: what divide() gives level by
    /// level, bit for bit.
    [[nodiscard]] std::vector<std::vector<PrimRef>> distribute(std::vector<PrimRef> prim_refs,
                                                               const Division& division) const;

private:
    std::vector<Node> nodes_;
    std::vector<Cell> cells_;
};

}  // namespace coppice::inline v0
