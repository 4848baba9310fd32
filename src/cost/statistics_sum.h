#pragma once

#include "coppice/cost/tree_statistics.h"

#include <cstdint>

namespace coppice::inline v0 {

/// Adds up a tree's statistics node by node.
class StatisticsSum {
public:
    /// `probability`: that a ray which meets the root's box also meets this node's; `cost`: what it
    /// then costs here.
    void add_inner(int depth, double probability, double cost);

    /// A leaf of `count` primitives, of which `tests` have to be tested one after the other.
    void add_leaf(int depth, double probability, std::uint64_t count, double tests, double cost);

    /// Everything, with shares and means; sah_cost is the sum of all costs.
    [[nodiscard]] TreeStatistics finish() &&;

private:
    void add_cost(int depth, double cost);

    TreeStatistics statistics_;
};

}  // namespace coppice::inline v0
