#include "coppice/trace/bvh8_tracer.h"

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/trace/brute_force.h"

#include "support/effort.h"
#include "support/meshes.h"
#include "support/numbers.h"
#include "support/random.h"
#include "support/rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace coppice::test {
namespace {

class EveryIsa : public testing::TestWithParam<Isa> {
protected:
    [[nodiscard]] static Bvh8Tracer make_tracer(const TriangleMesh& mesh) {
        return {build_bvh8(mesh.view()).tree, GetParam()};
    }
};

TEST_P(EveryIsa, HasNoGapSeenFromInside) {
    for (const Vec3f& offset : {Vec3f{}, Vec3f{148376, 1234, -223423}}) {
        TriangleMesh mesh = make_sphere(40, 41);
        for (Vec3f& vertex : mesh.vertices) {
            vertex = vertex + offset;
        }
        const Bvh8Tracer tracer = make_tracer(mesh);
        Random random(19);
        for (int i = 0; i < effort(20'000); ++i) {
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
    const Bvh8Tracer tracer = make_tracer(make_sphere(10, 11));
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
    EXPECT_FALSE(Bvh8Tracer(Bvh8(), GetParam()).intersect({{0, 0, 0}, {0, 0, 1}}).has_value());
}

TEST_P(EveryIsa, KeepsToTheLimitsOfTheRay) {
    const Bvh8Tracer tracer = make_tracer(make_sheet(4, {-1, -1, 2}, {0.5F, 0, 0}, {0, 0.5F, 0}));
    const Vec3f up{0, 0, 1};
    EXPECT_TRUE(tracer.occluded({{0.1F, 0.2F, 0}, up, 0.0F, 2.0F}));
    EXPECT_TRUE(tracer.occluded({{0.1F, 0.2F, 0}, up, 2.0F, 3.0F}));
    EXPECT_FALSE(tracer.occluded({{0.1F, 0.2F, 0}, up, 0.0F, std::nextafter(2.0F, 0.0F)}));
    EXPECT_FALSE(tracer.occluded({{0.1F, 0.2F, 0}, up, std::nextafter(2.0F, 3.0F), 9.0F}));
    EXPECT_TRUE(tracer.occluded({{0.1F, 0.2F, 5}, up, -4.0F, 0.0F})) << "behind, but on the ray";
}

std::vector<Hit> all_hits(const TriangleMesh& mesh, const Ray& ray) {
    std::vector<Hit> hits(mesh.view().size());
    hits.resize(brute_force_intersect_all(mesh.view(), ray, hits));
    return hits;
}

// Sheets above each other, three of them at one height.
TriangleMesh make_sheets() {
    TriangleMesh stack;
    for (const float height : {3.0F, 1.0F, 2.0F, 1.0F, 2.5F, 1.0F}) {
        stack =
            joined(std::move(stack), make_sheet(6, {-1, -1, height}, {0.3F, 0, 0}, {0, 0.3F, 0}));
    }
    return stack;
}

TEST_P(EveryIsa, FindsAllHitsInOrderAndGoesOn) {
    const TriangleMesh mesh = make_sheets();
    const Bvh8Tracer tracer = make_tracer(mesh);
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        // Every third ray goes through corners: there, hits of one distance have many ids.
        const Triangle any = mesh.view().triangle(random.below(mesh.view().size()));
        const Vec3f target = i % 3 == 0 ? any[0] : random.in_box({{0, 0, 1}, {0.5F, 0.5F, 1}});
        const Ray ray = ray_through({0.1F, 0.05F, -1}, target);
        const std::vector<Hit> expected = all_hits(mesh, ray);
        EXPECT_EQ(tracer.count_hits(ray), expected.size());
        for (const std::size_t at_once : {1U, 4U, 100U}) {
            std::vector<Hit> buffer(at_once);
            std::vector<Hit> found;
            std::size_t count = tracer.intersect_all(ray, buffer);
            while (count > 0) {
                found.insert(found.end(), buffer.begin(),
                             buffer.begin() + static_cast<std::ptrdiff_t>(count));
                if (count < at_once) break;
                count = tracer.intersect_all(ray, buffer, &found.back());
            }
            ASSERT_EQ(found, expected) << at_once << " at once, ray " << i;
        }
    }
}

TEST_P(EveryIsa, CountsMoreHitsThanItKeeps) {
    TriangleMesh mesh = make_triangle({Vec3f{-1, -1, 0}, Vec3f{1, -1, 0}, Vec3f{0, 1, 0}});
    mesh.triangles.resize(1000, mesh.triangles.front());
    EXPECT_EQ(make_tracer(mesh).count_hits({{0, 0, -1}, {0, 0.1F, 1}}), 1000U);
}

void expect_all_like_single(const Bvh8Tracer& tracer, std::span<const Ray> rays, int threads) {
    constexpr std::size_t room = 3;
    std::vector<Hit> hits(room * rays.size());
    std::vector<std::size_t> found(rays.size());
    std::vector<std::size_t> counts(rays.size());
    tracer.intersect_all(rays, hits, found, threads);
    tracer.count_hits(rays, counts, threads);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        std::array<Hit, room> expected;
        ASSERT_EQ(found[i], tracer.intersect_all(rays[i], expected)) << i;
        ASSERT_TRUE(std::equal(expected.begin(), expected.begin() + found[i],
                               hits.begin() + static_cast<std::ptrdiff_t>(room * i)));
        ASSERT_EQ(counts[i], tracer.count_hits(rays[i])) << i;
    }
}

void expect_batch_like_single(const Bvh8Tracer& tracer, std::span<const Ray> rays, int threads) {
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> is_occluded(rays.size(), 7);
    tracer.intersect(rays, hits, threads);
    tracer.occluded(rays, is_occluded, threads);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(hits[i], tracer.intersect(rays[i]).value_or(Hit{})) << i;
        ASSERT_EQ(is_occluded[i], tracer.occluded(rays[i]) ? 1 : 0) << i;
        ASSERT_EQ(hits[i].is_hit(), is_occluded[i] == 1) << i;
    }
}

TEST_P(EveryIsa, BatchesAreWhatSingleRaysAre) {
    const TriangleMesh mesh = make_sphere(20, 21);
    const Bvh8Tracer tracer = make_tracer(mesh);
    Random random(5);
    std::vector<Ray> rays(5000);
    for (Ray& ray : rays) {
        ray = {2.0F * to_float(random.direction()), to_float(random.direction())};
    }
    for (const int threads : {1, 2, 0}) {
        expect_batch_like_single(tracer, rays, threads);
        expect_all_like_single(tracer, rays, threads);
    }
    std::vector<Hit> too_few(rays.size() - 1);
    std::vector<std::size_t> found(rays.size());
    std::vector<std::size_t> counts(rays.size() + 1);
    EXPECT_THROW(tracer.intersect(rays, too_few), Error);
    EXPECT_THROW(tracer.intersect_all(rays, too_few, found), Error);
    EXPECT_THROW(tracer.count_hits(rays, counts), Error);
    EXPECT_THROW(tracer.intersect_all(rays, {}, found, -1), Error);
    tracer.intersect_all(rays, {}, found);  // room for no hit of any ray
    EXPECT_EQ(found, std::vector<std::size_t>(rays.size(), 0));
}

// Rays that go the same way are traced together: from one point or from several, towards points
// that are next to each other, vertices and edges among them; with limits of their own, and with
// some that hit nothing.
TEST_P(EveryIsa, RaysThatGoTheSameWayAreWhatSingleRaysAre) {
    for (const Vec3f& offset : {Vec3f{}, Vec3f{148376, 1234, -223423}}) {
        TriangleMesh mesh = make_sphere(40, 41);
        for (Vec3f& vertex : mesh.vertices) {
            vertex = vertex + offset;
        }
        const Bvh8Tracer tracer = make_tracer(mesh);
        Random random(6);
        std::vector<Ray> rays;
        for (int bundle = 0; bundle < effort(2000); ++bundle) {
            const Triangle around = mesh.view().triangle(random.below(mesh.view().size()));
            const Vec3f eye = offset + random.uniform(0, 3) * to_float(random.direction());
            const float spread = random.below(2) == 0 ? 0.0F : 0.05F;
            for (int i = 0; i < 8; ++i) {
                const Vec3f origin = eye + spread * to_float(random.direction());
                const float share = random.below(3) == 0 ? 0.0F : random.uniform(0, 1);
                Ray& ray = rays.emplace_back(
                    ray_through(origin, around[0] + share * (around[1] - around[0])));
                if (random.below(8) == 0) ray.t_min = random.uniform(0, 1);
                if (random.below(8) == 0) ray.t_max = random.uniform(0, 2);
                if (random.below(400) == 0) ray.direction.y = random.below(2) == 0 ? 0.0F : nan;
            }
        }
        expect_batch_like_single(tracer, rays, 1);
    }
}

TEST_P(EveryIsa, CountsWhatItDoes) {
    const TriangleMesh mesh = make_sphere(20, 21);
    const Bvh8Tracer tracer = make_tracer(mesh);
    TraversalCounts counts;
    EXPECT_TRUE(tracer.intersect({{0, 0, 0}, {0.3F, 0.2F, 1}}, counts).has_value());
    EXPECT_GE(counts.nodes, 1U);
    EXPECT_GE(counts.leaves, 1U);
    EXPECT_GE(counts.primitives, 8 * counts.leaves);
    const TraversalCounts one_ray = counts;
    EXPECT_FALSE(tracer.occluded({{9, 9, 9}, {1, 1, 1}}, counts));
    EXPECT_EQ(counts.nodes, one_ray.nodes + 1) << "the root, and no more";
    EXPECT_EQ(counts.leaves, one_ray.leaves);
}

INSTANTIATE_TEST_SUITE_P(All, EveryIsa,
                         testing::ValuesIn(available_isas().begin(), available_isas().end()),
                         [](const auto& each) {
                             std::string name(name_of(each.param));
                             std::erase(name, '.');  // "sse4.2"
                             return name;
                         });

}  // namespace
}  // namespace coppice::test
