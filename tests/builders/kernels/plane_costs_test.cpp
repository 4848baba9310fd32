#include "builders/kernels/plane_costs.h"

#include "builders/kernels/kd_kernels.h"
#include "builders/prim_refs.h"
#include "builders/split/best_split.h"
#include "builders/split/evaluate_plane.h"

#include <gtest/gtest.h>

#include <limits>

namespace coppice::test {
namespace {

BestSplit best_by_scalar_code(const std::vector<PrimRef>& prim_refs, Axis axis,
                              const SahCostModel& model) {
    const PlaneEvaluator evaluator(unit_cube, axis, model);
    BestSplit best;
    for (const PrimRef& prim_ref : prim_refs) {
        for (const float end : {prim_ref.box.lower[axis], prim_ref.box.upper[axis]}) {
            if (!evaluator.is_inside(end)) continue;
            best.offer(evaluate_plane({prim_refs, unit_cube, model, 0.0}, {axis, end}));
        }
    }
    return best;
}

// The best plane and its cost are, bit for bit, those of evaluate_plane() on all ends.
TEST(FindBestPlane, EqualsTheScalarCode_3) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Random random(3);
    const SahCostModel model{.traversal = 1.5, .intersection = 2.0, .empty_bonus = 0.3};
    for (const Layout layout :
         {Layout::random, Layout::grid, Layout::planar, Layout::points, Layout::identical}) {
        for (int round = 0; round < 200; ++round) {
            auto prim_refs = make_prim_refs(layout, 1 + random.below(64), random);
            const bool has_weights = round % 2 == 1;
            if (has_weights) prim_refs.front().weight = 2.25F;
            const auto axis = static_cast<Axis>(random.below(3));
            std::array<float, 64> lower;
            std::array<float, 64> upper;
            std::array<float, 64> weight{};
            lower.fill(infinity);
            upper.fill(-infinity);
            AxisEnds ends{lower.data(),     upper.data(), weight.data(),
                          prim_refs.size(), false,        !has_weights};
            const PlaneEvaluator evaluator(unit_cube, axis, model);
            for (std::size_t i = 0; i < prim_refs.size(); ++i) {
                lower[i] = prim_refs[i].box.lower[axis];
                upper[i] = prim_refs[i].box.upper[axis];
                weight[i] = prim_refs[i].weight;
                ends.has_planar |= lower[i] == upper[i];
            }
            const BestSplit expected = best_by_scalar_code(prim_refs, axis, model);
            for (const Isa isa : available_isas()) {
                const BestPlane best = kd_kernels_for(isa).find_best_plane(ends, evaluator.terms());
                ASSERT_EQ(best.cost, expected.cost());
                if (!expected.get()) continue;
                EXPECT_EQ(best.position, expected.get()->plane.position);
            }
        }
    }
}

// Most lies in the node's upper face, where no plane may be: the last end is the best there is.
TEST(FindBestPlane, KeepsTheLastEndBeforeTheFace) {
    std::vector<PrimRef> prim_refs(12, {{{0.1F, 0, 0}, {0.3F, 1, 1}}, 0});
    for (std::size_t i = 0; i < 9; ++i) {
        prim_refs[i].box = {{1, 0, 0}, {1, 1, 1}};
    }
    const SahCostModel model{.empty_bonus = 0.0};
    const auto split = find_split_finder("exact").find({prim_refs, unit_cube, model, 100.0});
    ASSERT_TRUE(split.has_value());
    EXPECT_EQ(split->plane, (SplitPlane{Axis::x, 0.3F}));
}

}  // namespace
}  // namespace coppice::test
