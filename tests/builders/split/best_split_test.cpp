#include "builders/split/best_split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace coppice::test {
namespace {

TEST(BestSplit, DoesNotMindTheOrder) {
    std::array<SplitCandidate, 4> splits{SplitCandidate{{Axis::y, 1.0F}, PlanarSide::below, 2.0},
                                         SplitCandidate{{Axis::x, 3.0F}, PlanarSide::below, 2.0},
                                         SplitCandidate{{Axis::x, 2.0F}, PlanarSide::below, 2.0},
                                         SplitCandidate{{Axis::x, 1.0F}, PlanarSide::below, 5.0}};
    const auto by_plane = [](const SplitCandidate& a, const SplitCandidate& b) {
        return std::pair(a.plane.axis, a.plane.position) <
               std::pair(b.plane.axis, b.plane.position);
    };
    std::sort(splits.begin(), splits.end(), by_plane);
    do {
        BestSplit best;
        for (const SplitCandidate& split : splits) {
            best.offer(split);
        }
        EXPECT_EQ(best.get()->plane, (SplitPlane{Axis::x, 2.0F}));
        EXPECT_EQ(best.cost(), 2.0);
    } while (std::next_permutation(splits.begin(), splits.end(), by_plane));
}

TEST(BestSplit, IsNothingAtFirst) {
    EXPECT_FALSE(BestSplit().get().has_value());
    EXPECT_GT(BestSplit().cost(), 1e300);
}

}  // namespace
}  // namespace coppice::test
