#include "coppice/json/tree_statistics.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace coppice::test {
namespace {

TEST(TreeStatisticsJson, HasAllFields) {
    const TreeStatistics statistics{.node_count = 5,
                                    .inner_count = 2,
                                    .leaf_count = 3,
                                    .single_primitive_leaf_count = 1,
                                    .empty_leaf_count = 1,
                                    .reference_count = 8,
                                    .max_level = 2,
                                    .mean_leaf_size = 2.5,
                                    .sah_cost = 7.25,
                                    .expected_inner_visits = 1.5,
                                    .expected_leaf_visits = 2.25,
                                    .expected_primitive_tests = 5.75,
                                    .depth_histogram = {0, 1, 2},
                                    .cost_share_by_depth = {0.25, 0.5, 0.25}};
    const nlohmann::json expected = {{"node_count", 5},
                                     {"inner_count", 2},
                                     {"leaf_count", 3},
                                     {"single_primitive_leaf_count", 1},
                                     {"empty_leaf_count", 1},
                                     {"reference_count", 8},
                                     {"max_level", 2},
                                     {"mean_leaf_size", 2.5},
                                     {"sah_cost", 7.25},
                                     {"expected_inner_visits", 1.5},
                                     {"expected_leaf_visits", 2.25},
                                     {"expected_primitive_tests", 5.75},
                                     {"depth_histogram", {0, 1, 2}},
                                     {"cost_share_by_depth", {0.25, 0.5, 0.25}}};
    EXPECT_EQ(nlohmann::json(statistics), expected);
}

}  // namespace
}  // namespace coppice::test
