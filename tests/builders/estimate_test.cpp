#include "coppice/builders/estimate.h"

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"

#include "support/meshes.h"
#include "support/primitives.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

void expect_near_share(double estimate, std::uint64_t found, double share, const char* what) {
    EXPECT_NEAR(estimate / static_cast<double>(found), 1.0, share) << what;
}

TEST(EstimateKdTree, IsWithinTheToleranceItClaims) {
    for (const TriangleMesh& mesh : {make_terrain(250, 1), make_soup(60000, 0.01F, 2)}) {
        for (const double rate : {1.0, 0.02}) {
            const KdOptions options{.sample = {.rate = rate}};
            const BuildEstimate estimate = estimate_kd_tree(mesh.view(), options);
            const BuildReport report = build_kd_tree(mesh.view(), options).report;
            expect_near_share(estimate.references, report.statistics.reference_count,
                              estimate_tolerance, "references");
            expect_near_share(estimate.bytes, report.tree_bytes, estimate_tolerance, "bytes");
            expect_near_share(estimate.peak_bytes, report.peak_bytes, kd_peak_estimate_tolerance,
                              "peak bytes");
            EXPECT_GT(estimate.seconds, 0.0);
        }
    }
}

TEST(EstimateKdTree, DependsOnNoThreadsButForTheSeconds) {
    const TriangleMesh mesh = make_terrain(120, 3);
    const BuildEstimate one = estimate_kd_tree(mesh.view(), {.threads = 1});
    const BuildEstimate two = estimate_kd_tree(mesh.view(), {.threads = 2});
    EXPECT_EQ(one.references, two.references);
    EXPECT_EQ(one.bytes, two.bytes);
}

TEST(EstimateKdTree, IsExactForSmallScenes) {
    const TriangleMesh mesh = make_soup(1000, 0.1F, 1);
    const KdTree tree = build_kd_tree(mesh.view()).tree;
    const BuildEstimate estimate = estimate_kd_tree(mesh.view(), {});
    EXPECT_EQ(estimate.references, static_cast<double>(tree.references().size()));
    EXPECT_EQ(estimate.bytes, static_cast<double>(tree.byte_count()));
    EXPECT_EQ(estimate_kd_tree(TriangleMeshView(), {}).references, 0.0);
}

TEST(EstimateKdTree, TakesPointsAndEqualPrimitives) {
    const TriangleMesh mesh = make_soup(20000, 0.1F, 1);
    const Primitives scene(mesh);
    const PrimitiveSetView points = scene.of(PrimitiveKind::points);
    expect_near_share(estimate_kd_tree(points, {}).references, points.size(), estimate_tolerance,
                      "points");
    TriangleMesh equal = make_soup(1, 0.1F, 1);
    equal.triangles.resize(40000, equal.triangles.front());
    EXPECT_NO_THROW(static_cast<void>(estimate_kd_tree(equal.view(), {})));
}

TEST(EstimateBvh8, IsWithinTheToleranceItClaims) {
    for (const TriangleMesh& mesh : {make_terrain(250, 1), make_soup(60000, 0.01F, 2)}) {
        for (const char* const name : {"fast", "quality"}) {
            const Bvh8Options options = find_method(name).bvh8_options();
            const BuildEstimate estimate = estimate_bvh8(mesh.view(), options);
            const BuildReport report = build_bvh8(mesh.view(), options).report;
            expect_near_share(estimate.references, report.statistics.reference_count,
                              estimate_tolerance, "references");
            expect_near_share(estimate.bytes, report.tree_bytes, estimate_tolerance, "bytes");
            expect_near_share(estimate.peak_bytes, report.peak_bytes, estimate_tolerance,
                              "peak bytes");
            EXPECT_GT(estimate.seconds, 0.0);
        }
    }
    EXPECT_EQ(estimate_bvh8(TriangleMeshView(), {}).references, 0.0);
}

TEST(EstimateKdTree, ChecksItsOptions) {
    const TriangleMesh mesh = make_soup(10, 0.1F, 4);
    EXPECT_THROW(static_cast<void>(estimate_kd_tree(mesh.view(), {.sample = {.rate = 0.0}})),
                 Error);
}

}  // namespace
}  // namespace coppice::test
