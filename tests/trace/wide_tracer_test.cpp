#include "coppice/trace/wide_tracer.h"

#include "coppice/build/build_tree.h"

#include "support/meshes.h"
#include "support/random.h"
#include "support/rays.h"

#include <gtest/gtest.h>

#include <limits>

namespace coppice::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

class EveryIsa : public testing::TestWithParam<Isa> {
protected:
    [[nodiscard]] static WideTracer make_tracer(const TriangleMesh& mesh) {
        return {build_wide_bvh(mesh.view()), GetParam()};
    }
};

TEST_P(EveryIsa, HasNoGapSeenFromInside) {
    for (const Vec3f& offset : {Vec3f{}, Vec3f{148376, 1234, -223423}}) {
        TriangleMesh mesh = make_sphere(40, 41);
        for (Vec3f& vertex : mesh.vertices) {
            vertex = vertex + offset;
        }
        const WideTracer tracer = make_tracer(mesh);
        Random random(19);
        for (int i = 0; i < 20'000; ++i) {
            const Triangle any = mesh.view().triangle(random.below(mesh.view().size()));
            const Vec3f middle = 0.5F * any[0] + 0.5F * any[1];
            for (const Vec3f& target : {any[2], middle, offset + to_float(random.direction())}) {
                ASSERT_TRUE(tracer.intersect(ray_through(offset, target)).has_value()) << i;
                ASSERT_TRUE(tracer.occluded(ray_through(offset, target))) << i;
            }
        }
    }
}

TEST_P(EveryIsa, BadRaysHitNothing) {
    const WideTracer tracer = make_tracer(make_sphere(10, 11));
    for (const Ray& bad : {
             Ray{{nan, 0, 0}, {0, 0, 1}},
             Ray{{0, 0, 0}, {0, nan, 1}},
             Ray{{0, 0, 0}, {0, 0, 0}},
             Ray{{0, 0, 0}, {0, -0.0F, 0}},
             Ray{{infinity, 0, 0}, {-1, 0, 0}},
             Ray{{0, 0, 0}, {0, 0, infinity}},
             Ray{{0, 0, 0}, {0, 0, 1}, 2.0F, 1.0F},
             Ray{{0, 0, 0}, {0, 0, 1}, 0.0F, -1.0F},
             Ray{{0, 0, 0}, {0, 0, 1}, nan, 1.0F},
             Ray{{0, 0, 0}, {0, 0, 1}, 0.0F, nan},
         }) {
        EXPECT_FALSE(tracer.intersect(bad).has_value());
        EXPECT_FALSE(tracer.occluded(bad));
    }
}

TEST_P(EveryIsa, NothingIsHitInNothing) {
    EXPECT_FALSE(WideTracer(WideBvh(), GetParam()).intersect({{0, 0, 0}, {0, 0, 1}}).has_value());
}

TEST_P(EveryIsa, KeepsToTheLimitsOfTheRay) {
    const WideTracer tracer = make_tracer(make_sheet(4, {-1, -1, 2}, {0.5F, 0, 0}, {0, 0.5F, 0}));
    const Vec3f up{0, 0, 1};
    EXPECT_TRUE(tracer.occluded({{0.1F, 0.2F, 0}, up, 0.0F, 2.0F}));
    EXPECT_TRUE(tracer.occluded({{0.1F, 0.2F, 0}, up, 2.0F, 3.0F}));
    EXPECT_FALSE(tracer.occluded({{0.1F, 0.2F, 0}, up, 0.0F, std::nextafter(2.0F, 0.0F)}));
    EXPECT_FALSE(tracer.occluded({{0.1F, 0.2F, 0}, up, std::nextafter(2.0F, 3.0F), 9.0F}));
    EXPECT_TRUE(tracer.occluded({{0.1F, 0.2F, 5}, up, -4.0F, 0.0F})) << "behind, but on the ray";
}

INSTANTIATE_TEST_SUITE_P(All, EveryIsa,
                         testing::ValuesIn(available_isas().begin(), available_isas().end()),
                         [](const auto& each) { return std::string(name_of(each.param)); });

}  // namespace
}  // namespace coppice::test
