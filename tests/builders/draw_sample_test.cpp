#include "coppice/builders/draw_sample.h"

#include "coppice/base/error.h"
#include "coppice/geom/point_cloud.h"
#include "coppice/geom/triangle_mesh.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace coppice::test {
namespace {

using Ids = std::vector<std::uint32_t>;

Sample draw_of(std::uint32_t count, const SampleOptions& options) {
    const std::vector<Vec3f> points(count);
    return draw_sample(PointCloudView(points), options);
}

TEST(DrawSample, HasTheSizeOfTheRate) {
    for (const double rate : {1.0, 0.5, 0.4, 0.3, 0.2, 0.1, 0.05, 0.04, 0.03, 0.02, 0.01, 1e-6}) {
        EXPECT_EQ(draw_of(1234, {.rate = rate}).ids.size(), sample_count(1234, rate));
    }
    EXPECT_TRUE(draw_of(0, {.rate = 0.5}).ids.empty());
    EXPECT_TRUE(draw_of(0, {}).ids.empty());
    EXPECT_EQ(draw_of(1, {.rate = 0.01}).ids, Ids{0});
}

TEST(DrawSample, OfAllIsAllInTheirOwnOrder) {
    Ids all(1000);
    std::iota(all.begin(), all.end(), 0U);
    EXPECT_EQ(draw_of(1000, {}).ids, all);
    EXPECT_EQ(draw_of(1000, {.rate = 0.9999}).ids, all);  // rounds to all
}

TEST(DrawSample, IsDistinctAscendingAndNested) {
    for (const std::uint64_t seed : {1U, 2U, 99U}) {
        Ids smaller;
        for (const double rate : {0.001, 0.01, 0.02, 0.1, 0.5, 0.9, 1.0}) {
            const Ids ids = draw_of(1000, {.rate = rate, .seed = seed}).ids;
            EXPECT_TRUE(std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) ==
                        ids.end());
            EXPECT_LT(ids.back(), 1000U);
            EXPECT_TRUE(std::includes(ids.begin(), ids.end(), smaller.begin(), smaller.end()));
            smaller = ids;
        }
    }
}

TEST(DrawSample, RecordsItsOptions) {
    const Sample sample = draw_of(1000, {.rate = 0.1, .sampler = "uniform", .seed = 42});
    EXPECT_EQ(sample.options.rate, 0.1);
    EXPECT_EQ(sample.options.sampler, "uniform");
    EXPECT_EQ(sample.options.seed, 42U);
}

TEST(DrawSample, UsesTheSamplerThatIsNamed) {
    const TriangleMesh mesh = make_soup(500, 0.1F, 1);
    for (const SamplerEntry& entry : sampler_registry()) {
        const SampleOptions options{.rate = 0.1, .sampler = std::string(entry.name), .seed = 8};
        EXPECT_EQ(draw_sample(mesh.view(), options).ids,
                  entry.sampler.draw(mesh.view(), 50, options).ids);
    }
}

TEST(DrawSample, RefusesBadOptions) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double rate : {0.0, -1.0, 1.01, nan}) {
        EXPECT_THROW(static_cast<void>(draw_of(10, {.rate = rate})), Error);
        EXPECT_THROW(static_cast<void>(draw_of(0, {.rate = rate})), Error);
    }
    EXPECT_THROW(static_cast<void>(draw_of(10, {.rate = 0.5, .sampler = "best"})), Error);
    EXPECT_THROW(static_cast<void>(draw_of(10, {.rate = 1.0, .sampler = "best"})), Error);
}

}  // namespace
}  // namespace coppice::test
