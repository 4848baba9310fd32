#pragma once

#include "coppice/tree/kd_node.h"

#include "builders/kd/partition.h"
#include "builders/top_tree.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// The upper part of a k-d tree as a TopTree, as far as PrimRefs descend in one pass.
class KdTopTree : public TopTree {
public:
    /// A node of the k-d tree with its box and its depth.
    struct Cell {
        std::uint32_t index;
        Aabb box;
        int depth;
    };

    /// Takes the nodes below `root` down to leaves, to nodes for which `ends_at(index)` is true,
    /// and to at most `level_count` levels.
    KdTopTree(std::span<const KdNode> tree, const Cell& root, int level_count,
              const std::function<bool(std::uint32_t)>& ends_at);

    /// The cells, indexed by cell number.
    [[nodiscard]] std::span<const Cell> cells() const noexcept { return cells_; }

    /// Distributes PrimRefs to the cells, in their order. Equals divide() level by level, to the
    /// bit.
    [[nodiscard]] std::vector<std::vector<PrimRef>> distribute(std::vector<PrimRef> prim_refs,
                                                               const Division& division) const;

private:
    std::vector<Cell> cells_;
};

}  // namespace coppice::inline v0
