// The 8-wide builder on the scenes that break builders: sound trees, hits as brute force finds
// them, and the same bytes for any number of threads and any instruction set.

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"
#include "coppice/trace/brute_force.h"
#include "coppice/trace/bvh8_tracer.h"

#include "builders/bvh8/cells.h"
#include "support/effort.h"
#include "support/isa.h"
#include "support/meshes.h"
#include "support/rays.h"
#include "support/scene_matrix.h"
#include "support/tree_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace coppice::test {
namespace {

// Small cells and no crossover, so that small scenes go the way of large ones.
std::vector<Bvh8Options> all_ways() {
    std::vector<Bvh8Options> ways;
    for (const double rate : {1.0, 0.2}) {
        for (const char* sampler : {"weighted", "uniform"}) {
            ways.push_back(
                {.sample = {.rate = rate, .sampler = sampler}, .cell_size = 64, .sampled_from = 0});
        }
    }
    ways.push_back({.preset = Bvh8Preset::quality});
    return ways;
}

class BuildBvh8Scene : public testing::TestWithParam<NamedScene> {};

TEST_P(BuildBvh8Scene, GivesSoundTrees) {
    const TriangleMesh mesh = GetParam().make();
    for (const Bvh8Options& options : all_ways()) {
        EXPECT_TRUE(is_sound(build_bvh8(mesh.view(), options).tree, mesh.view()))
            << options.sample.sampler << " " << options.sample.rate;
    }
}

TEST_P(BuildBvh8Scene, IsTheSameForAllThreadsAndInstructionSets) {
    const TriangleMesh mesh = GetParam().make();
    for (Bvh8Options options : all_ways()) {
        const Bvh8 expected = build_bvh8(mesh.view(), options).tree;
        for (const int threads : {1, 2, 3, 8}) {
            options.threads = threads;
            EXPECT_TRUE(is_same(build_bvh8(mesh.view(), options).tree, expected)) << threads;
        }
        for (const Isa isa : available_isas()) {
            const ForceIsa force(isa);
            EXPECT_TRUE(is_same(build_bvh8(mesh.view(), options).tree, expected)) << name_of(isa);
        }
    }
}

testing::AssertionResult agrees(const Bvh8Tracer& tracer, TriangleMeshView mesh, const Ray& ray) {
    const auto expected = brute_force_intersect(mesh, ray);
    const auto hit = tracer.intersect(ray);
    const bool is_same = hit.has_value() == expected.has_value() &&
                         tracer.occluded(ray) == expected.has_value() &&
                         (!hit || (hit->t == expected->t && hit->prim == expected->prim));
    return is_same ? testing::AssertionSuccess() : testing::AssertionFailure();
}

testing::AssertionResult agrees(const Bvh8Tracer& tracer, TriangleMeshView mesh, RaySource rays) {
    const int ray_count = effort(mesh.size() > 1500 ? 8 : 40);
    for (const RayKind kind : all_ray_kinds) {
        for (int i = 0; i < ray_count; ++i) {
            if (agrees(tracer, mesh, rays.next(kind))) continue;
            return testing::AssertionFailure() << name_of(kind) << " " << i;
        }
    }
    return testing::AssertionSuccess();
}

TEST_P(BuildBvh8Scene, IsHitAsByBruteForce) {
    const TriangleMesh mesh = GetParam().make();
    const KdTree planes = build_kd_tree(mesh.view()).tree;
    for (const Bvh8Options& options : all_ways()) {
        const Bvh8 tree = build_bvh8(mesh.view(), options).tree;
        for (const Isa isa : available_isas()) {
            const Bvh8Tracer tracer(tree, isa);
            EXPECT_TRUE(agrees(tracer, mesh.view(), RaySource(mesh, planes, 41))) << name_of(isa);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seed41, BuildBvh8Scene, testing::ValuesIn(scene_matrix()), scene_name);

TEST(BuildBvh8, CountsWhatItBuilt) {
    const TriangleMesh mesh = make_sphere(60, 61);
    const auto [tree, report] = build_bvh8(
        mesh.view(), {.sample = {.rate = 0.1, .sampler = "weighted"}, .sampled_from = 0});
    EXPECT_EQ(report.primitive_count, mesh.triangles.size());
    EXPECT_EQ(report.statistics.reference_count, mesh.triangles.size());
    EXPECT_EQ(report.statistics.inner_count, tree.nodes().size());
    EXPECT_LE(report.sample_count, mesh.triangles.size() / 9);
}

TEST(BuildBvh8, DoesNotSampleSmallScenes) {
    const TriangleMesh mesh = make_sphere(60, 61);
    const auto [sampled, report] = build_bvh8(mesh.view(), {.sample = {.rate = 0.1}});
    EXPECT_EQ(report.sample_count, mesh.triangles.size());
    EXPECT_TRUE(is_same(sampled, build_bvh8(mesh.view()).tree));
}

// The method auto is what the library does by itself; the report tells the sample that was drawn.
TEST(BuildBvh8, AutomaticSamplesAsThePresetThatItTakes) {
    const TriangleMesh mesh = make_sphere(60, 61);
    const auto built = [&](const char* method, double expected_rays) {
        Bvh8Options options =
            method == nullptr ? Bvh8Options{} : find_method(method).bvh8_options();
        options.sampled_from = 0;
        options.expected_rays = expected_rays;
        return build_bvh8(mesh.view(), options);
    };
    for (const double rays : {0.0, 1e9}) {
        const auto [by_options, report] = built(nullptr, rays);
        const auto [by_name, report_by_name] = built("auto", rays);
        const auto [named, named_report] = built(rays == 0.0 ? "fast" : "quality", rays);
        EXPECT_TRUE(is_same(by_options, named)) << rays;
        EXPECT_TRUE(is_same(by_name, named)) << rays;
        EXPECT_EQ(report.sample.rate, rays == 0.0 ? 0.01 : 1.0);
        EXPECT_EQ(report_by_name.sample_count, named_report.sample_count);
    }
}

TEST(BuildBvh8, RefusesMoreTrianglesThanItsBlocksCanHold) {
    const TriangleMesh mesh = make_soup(1, 0.1F, 1);
    const std::span<const TriangleIndices> many(mesh.triangles.data(), (std::size_t{1} << 30) + 1);
    try {
        static_cast<void>(build_bvh8({mesh.vertices, many}));  // which looks at none of them
        ADD_FAILURE() << "no exception";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::limit);
        EXPECT_STREQ(
            error.what(),
            "the mesh has 1073741825 triangles; an 8-wide tree can hold at most 1073741824");
    }
}

// A leaf of two walls that meet would be tested by every ray from inside.
TEST(BuildBvh8, SplitsTheWallsOfARoom) {
    TriangleMesh mesh = make_sphere(60, 61);
    for (const float at : {-10.0F, 10.0F}) {
        mesh = joined(std::move(mesh), make_sheet(1, {at, -10, -10}, {0, 20, 0}, {0, 0, 20}));
        mesh = joined(std::move(mesh), make_sheet(1, {-10, at, -10}, {20, 0, 0}, {0, 0, 20}));
        mesh = joined(std::move(mesh), make_sheet(1, {-10, -10, at}, {20, 0, 0}, {0, 20, 0}));
    }
    for (const Bvh8Options& options : all_ways()) {
        const Bvh8 tree = build_bvh8(mesh.view(), options).tree;
        for (const Bvh8Node& node : tree.nodes()) {
            for (std::size_t slot = 0; slot < bvh8_width; ++slot) {
                if (!node.child[slot].is_leaf()) continue;
                const Vec3f edges = node.child_box(slot).upper - node.child_box(slot).lower;
                EXPECT_LE(edges.x * edges.y * edges.z, 80.0F) << "of 8000";
            }
        }
    }
}

TEST(BuildBvh8, LeavesTriangleTogetherThatSplitsCannotPart) {
    const TriangleMesh slopes = repeated(make_triangle({Vec3f{0, 0, 0}, {9, 9, 0}, {0, 9, 9}}), 64);
    EXPECT_EQ(build_bvh8(slopes.view()).tree.blocks().size(), 8U);
}

TEST(BuildBvh8, NamesTheFirstTriangleThatIsNotFinite) {
    TriangleMesh mesh = make_soup(100, 0.1F, 1);
    mesh.vertices[mesh.triangles[61][1]].y = std::numeric_limits<float>::infinity();
    mesh.vertices[mesh.triangles[77][0]].x = std::numeric_limits<float>::quiet_NaN();
    try {
        static_cast<void>(build_bvh8(mesh.view()));
        ADD_FAILURE() << "no exception";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        EXPECT_THAT(error.what(), testing::HasSubstr("primitive 61 "));
    }
}

TEST(BuildBvh8, IsNeverTooDeep) {
    // Each triangle a tenth of the one before: a split by cost peels off one after the other.
    TriangleMesh mesh;
    float size = 1e30F;
    for (int i = 0; i < 600; ++i) {
        mesh = joined(std::move(mesh), scaled(make_soup(1, 0.5F, 3), size));
        size *= 0.9F;
    }
    EXPECT_TRUE(is_sound(build_bvh8(mesh.view()).tree, mesh.view()));
}

// Cells by planes hold more references than there are triangles.
TEST(BuildBvh8, RefusesMoreReferencesThanItCanName) {
    constexpr std::size_t most = 0xffffffff;
    const std::vector<bvh8::Range> ranges =
        bvh8::make_ranges(std::vector{std::size_t{3}, most - 3});
    EXPECT_EQ(ranges[1].begin, 3U);
    EXPECT_EQ(ranges[1].end, most);
    for (const std::vector<std::size_t>& sizes :
         {std::vector{most + 1}, std::vector{most, std::size_t{1}}}) {
        try {
            static_cast<void>(bvh8::make_ranges(sizes));
            FAIL() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::limit);
            EXPECT_STREQ(
                error.what(),
                "the tree would have 4294967296 references; at most 4294967295 are possible");
        }
    }
}

}  // namespace
}  // namespace coppice::test
