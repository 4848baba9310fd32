#include "build/kernels/plane_costs.h"

#include "build/fragments.h"
#include "build/split/evaluate_plane.h"

#include <gtest/gtest.h>

#include <limits>

namespace coppice::test {
namespace {

// Counts and costs of every plane are, bit for bit, those of evaluate_plane().
TEST(FindPlaneCosts, EqualsTheScalarCode_3) {
    Random random(3);
    const SahCostModel model{.traversal = 1.5, .intersection = 2.0, .empty_bonus = 0.3};
    for (const Layout layout : {Layout::random, Layout::grid, Layout::planar, Layout::points}) {
        for (int round = 0; round < 100; ++round) {
            auto fragments = make_fragments(layout, 1 + random.below(64), random);
            fragments.front().weight = 2.25F;
            const auto axis = static_cast<Axis>(random.below(3));
            std::array<float, 64> lower{};
            std::array<float, 64> upper{};
            std::array<float, 64> weight{};
            AxisEnds ends{lower.data(), upper.data(), weight.data(), fragments.size(), false};
            AxisPlanes planes;
            for (std::size_t i = 0; i < fragments.size(); ++i) {
                lower[i] = fragments[i].box.lower[axis];
                upper[i] = fragments[i].box.upper[axis];
                weight[i] = fragments[i].weight;
                ends.has_planar |= lower[i] == upper[i];
                planes.position[planes.count++] = random.uniform(0.01F, 0.99F);
                if (lower[i] > 0.0F && lower[i] < 1.0F) planes.position[planes.count++] = lower[i];
            }
            const PlaneEvaluator evaluator(unit_cube, axis, model);
            const double least = find_plane_costs(ends, evaluator.terms(), planes);
            double expected_least = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < planes.count; ++i) {
                const Split split =
                    evaluate_plane({fragments, unit_cube, model, 0.0}, {axis, planes.position[i]});
                EXPECT_EQ(planes.cost[i], split.cost);
                expected_least = std::min(expected_least, split.cost);
            }
            EXPECT_EQ(least, expected_least);
        }
    }
}

}  // namespace
}  // namespace coppice::test
