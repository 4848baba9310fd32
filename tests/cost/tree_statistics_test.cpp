#include "coppice/cost/tree_statistics.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(TreeStatistics, IsOfNothingByDefault) {
    EXPECT_EQ(TreeStatistics{}.node_count, 0U);
    EXPECT_EQ(TreeStatistics{}.sah_cost, 0.0);
    EXPECT_TRUE(TreeStatistics{}.depth_histogram.empty());
}

}  // namespace
}  // namespace coppice::test
