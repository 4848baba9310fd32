#pragma once

#include "coppice/cost/tree_statistics.h"

#include <cstdint>

namespace coppice::inline v0 {

/// Sums up a tree's statistics node by node.
class StatisticsSum {
public:
    /// Adds an inner node. `probability`: that a ray which meets the root's box also meets this
    /// node's. `cost`: what the node costs such a ray.
    void add_inner(int depth, double probability, double cost);

    /// Adds a leaf of `count` primitives that takes `tests` intersection tests one after the other.
    void add_leaf(int depth, double probability, std::uint64_t count, double tests, double cost);

    /// The complete statistics, with shares and means. sah_cost is the sum of all costs.
    [[nodiscard]] TreeStatistics finish() &&;

private:
    void add_cost(int depth, double cost);

    TreeStatistics statistics_;
};

}  // namespace coppice::inline v0
