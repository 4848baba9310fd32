#pragma once

#include "coppice/tree/kd_node.h"

#include "builders/kd/partition.h"
#include "builders/top_tree.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// The upper part of a k-d tree as a TopTree, as far down as PrimRefs are sent at once.
class KdTopTree : public TopTree {
public:
    /// A node of the k-d tree, its box and its depth.
    struct Cell {
        std::uint32_t index;
        Aabb box;
        int depth;
    };

    /// The nodes below `root` down to leaves, to those that `ends_at(index)`, and to `level_count`
    /// levels.
    KdTopTree(std::span<const KdNode> tree, const Cell& root, int level_count,
              const std::function<bool(std::uint32_t)>& ends_at);

    /// By their numbers.
    [[nodiscard]] std::span<const Cell> cells() const noexcept { return cells_; }

    /// The PrimRefs of every cell, each in the order of the root's: what divide() gives level by
    /// level, bit for bit.
    [[nodiscard]] std::vector<std::vector<PrimRef>> distribute(std::vector<PrimRef> prim_refs,
                                                               const Division& division) const;

private:
    std::vector<Cell> cells_;
};

}  // namespace coppice::inline v0
