#pragma once

#include <cstdint>
#include <vector>

namespace coppice::inline v0 {

/// The size of a tree and its expected cost for a random line through its box. Expectations are per
/// ray that meets the tree's box, by the surface area heuristic.
struct TreeStatistics {
    std::uint64_t node_count = 0;                   ///< inner nodes and leaves
    std::uint64_t inner_count = 0;                  ///< nodes with children
    std::uint64_t leaf_count = 0;                   ///< empty ones included
    std::uint64_t single_primitive_leaf_count = 0;  ///< leaves of one reference
    std::uint64_t empty_leaf_count = 0;             ///< leaves of no reference
    std::uint64_t reference_count = 0;              ///< references of all leaves
    int max_level = 0;            ///< depth of the deepest leaf; a lone root is level 0
    double mean_leaf_size = 0.0;  ///< references per leaf, empty leaves included

    double sah_cost = 0.0;                  ///< in the unit of the cost model
    double expected_inner_visits = 0.0;     ///< inner nodes that a ray visits
    double expected_leaf_visits = 0.0;      ///< leaves that a ray visits, empty ones included
    double expected_primitive_tests = 0.0;  ///< primitives that a ray is tested against

    std::vector<std::uint64_t> depth_histogram;  ///< leaves at each level, 0 to max_level
    std::vector<double> cost_share_by_depth;     ///< share of sah_cost at each level; sums to 1
};

}  // namespace coppice::inline v0
