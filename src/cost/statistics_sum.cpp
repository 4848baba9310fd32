#include "cost/statistics_sum.h"

#include <algorithm>
#include <utility>

namespace coppice::inline v0 {

void StatisticsSum::add_inner(int depth, double probability, double cost) {
    ++statistics_.inner_count;
    statistics_.expected_inner_visits += probability;
    add_cost(depth, probability * cost);
}

void StatisticsSum::add_leaf(int depth, double probability, std::uint64_t count, double tests,
                             double cost) {
    ++statistics_.leaf_count;
    statistics_.single_primitive_leaf_count += count == 1 ? 1 : 0;
    statistics_.empty_leaf_count += count == 0 ? 1 : 0;
    statistics_.reference_count += count;
    statistics_.expected_leaf_visits += probability;
    statistics_.expected_primitive_tests += probability * tests;
    statistics_.max_level = std::max(statistics_.max_level, depth);
    add_cost(depth, probability * cost);
    ++statistics_.depth_histogram[static_cast<std::size_t>(depth)];
}

TreeStatistics StatisticsSum::finish() && {
    statistics_.node_count = statistics_.inner_count + statistics_.leaf_count;
    if (statistics_.leaf_count > 0) {
        statistics_.mean_leaf_size = static_cast<double>(statistics_.reference_count) /
                                     static_cast<double>(statistics_.leaf_count);
    }
    for (const double cost : statistics_.cost_share_by_depth) {
        statistics_.sah_cost += cost;
    }
    for (double& share : statistics_.cost_share_by_depth) {
        share = statistics_.sah_cost > 0.0 ? share / statistics_.sah_cost : 0.0;
    }
    return std::move(statistics_);
}

void StatisticsSum::add_cost(int depth, double cost) {
    const auto level = static_cast<std::size_t>(depth);
    if (level >= statistics_.cost_share_by_depth.size()) {
        statistics_.cost_share_by_depth.resize(level + 1);
        statistics_.depth_histogram.resize(level + 1);
    }
    statistics_.cost_share_by_depth[level] += cost;
}

}  // namespace coppice::inline v0
