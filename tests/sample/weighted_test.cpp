#include "sample/weighted.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace coppice::test {
namespace {

// A thousand small triangles and one across the scene, of id 1000.
TriangleMesh make_one_huge() {
    return joined(make_soup(1000, 0.001F, 1), make_sheet(1, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
}

TEST(WeightedSampler, NeverMissesAHugePrimitive) {
    const TriangleMesh mesh = make_one_huge();
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Sample sample = WeightedSampler().draw(mesh.view(), 20, {.seed = seed});
        ASSERT_TRUE(std::binary_search(sample.ids.begin(), sample.ids.end(), 1000U));
        EXPECT_EQ(sample.weights.back(), 1.0F) << "it stands for itself alone";
    }
}

TEST(WeightedSampler, DrawsEachAsOftenAsItsWeightSays) {
    const TriangleMesh mesh = make_one_huge();
    constexpr int draws = 3000;
    std::vector<double> times(mesh.triangles.size(), 0.0);
    std::vector<double> weights(mesh.triangles.size(), 0.0);
    for (std::uint64_t seed = 0; seed < draws; ++seed) {
        const Sample sample = WeightedSampler().draw(mesh.view(), 100, {.seed = seed});
        for (std::size_t at = 0; at < sample.ids.size(); ++at) {
            times[sample.ids[at]] += 1.0;
            weights[sample.ids[at]] = static_cast<double>(sample.weights[at]);
        }
    }
    for (std::size_t id = 0; id < times.size(); ++id) {
        // Standard deviation of a frequency near 0.1: 0.0055.
        EXPECT_NEAR(times[id] / draws, 1.0 / weights[id], 0.03) << id;
    }
}

TEST(WeightedSampler, FillsUpWithPrimitivesWithoutDiagonal) {
    const TriangleMesh mesh = joined(make_soup(10, 0.1F, 1), make_degenerate_points(990, 2));
    for (const double share : {0.0, 1e-9, 0.5}) {
        const Sample sample =
            WeightedSampler().draw(mesh.view(), 200, {.seed = 3, .uniform_share = share});
        EXPECT_EQ(sample.ids.size(), 200U) << share;
        EXPECT_EQ(std::adjacent_find(sample.ids.begin(), sample.ids.end()), sample.ids.end());
    }
}

TEST(WeightedSampler, IsStratifiedWhereAllShareAlike) {
    const TriangleMesh mesh = make_one_huge();
    const Sample sample =
        WeightedSampler().draw(mesh.view(), 91, {.seed = 3, .uniform_share = 1.0});
    EXPECT_EQ(sample.ids.size(), 91U);
    for (const float weight : sample.weights) {
        EXPECT_FLOAT_EQ(weight, static_cast<float>(mesh.triangles.size()) / 91.0F);
    }
}

}  // namespace
}  // namespace coppice::test
