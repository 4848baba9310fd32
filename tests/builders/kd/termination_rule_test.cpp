#include "builders/kd/termination_rule.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

constexpr Aabb cube{{0, 0, 0}, {1, 1, 1}};
const SahCostModel cost{.traversal = 2.0};

TEST(TerminationRule, OfTheThesisEndsAtItsLimits) {
    const TerminationRule rule{4, 2, 10, SplitSearch::first_offer, 0.0};
    EXPECT_TRUE(rule.ends_at({cube}, 0.0, cost));
    EXPECT_TRUE(rule.ends_at({cube}, 4.0, cost));
    EXPECT_FALSE(rule.ends_at({cube}, 4.5, cost));
    EXPECT_TRUE(rule.ends_at({cube, 10}, 100.0, cost));
    EXPECT_TRUE(rule.ends_at({{{0, 0, 0}, {1, 0, 0}}}, 100.0, cost)) << "no area";
    NodeState node{cube};
    EXPECT_TRUE(rule.accepts(9.0, 10.0, node));
    EXPECT_TRUE(rule.accepts(10.0, 10.0, node)) << "one bad refine";
    EXPECT_FALSE(rule.accepts(11.0, 10.0, node)) << "the second";
}

TEST(TerminationRule, GoesOnAsLongAsSplitsPay) {
    const TerminationRule rule =
        until_it_pays({.max_depth = 10, .min_split = 2, .max_duplication = 3});
    EXPECT_FALSE(rule.ends_at({cube}, 2.5, cost));
    EXPECT_TRUE(rule.ends_at({cube}, 2.0, cost)) << "as cheap as passing a node";
    EXPECT_TRUE(rule.ends_at({cube}, 1.0, {.traversal = 0.0})) << "too few";
    NodeState node{cube};
    EXPECT_FALSE(rule.ends_at(node.child(cube, 1.5).child(cube, 2.0), 100.0, cost));
    EXPECT_TRUE(rule.ends_at(node.child(cube, 2.0).child(cube, 2.0), 100.0, cost));
    EXPECT_FALSE(rule.accepts(10.0, 10.0, node));
}

}  // namespace
}  // namespace coppice::test
