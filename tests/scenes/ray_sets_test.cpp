#include "scenes/ray_sets.h"

#include "coppice/trace/brute_force.h"

#include "scenes/procedural.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coppice::lab {

namespace {

/// A small scene with its primary rays and their hits.
struct Example {
    explicit Example(int size = 32) {
        camera = render::frame_box(bounds_of(mesh.vertices), {}, 1.0);
        rays = primary_rays(camera, size);
        for (const Ray& ray : rays) {
            hits.push_back(brute_force_intersect(mesh.view(), ray).value_or(Hit{}));
            hit_count += std::isfinite(hits.back().t) ? 1 : 0;
        }
    }

    TriangleMesh mesh = make_procedural("spheres", 500, 1);
    render::Camera camera;
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    std::size_t hit_count = 0;
};

bool is_equal(const std::vector<Ray>& a, const std::vector<Ray>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Ray& x, const Ray& y) {
        return x.origin == y.origin && x.direction == y.direction && x.t_min == y.t_min &&
               x.t_max == y.t_max;
    });
}

double length(Vec3d v) {
    return std::sqrt(dot(v, v));
}

TEST(PrimaryRays, AreOneAPixelAndHitWhatIsFramed) {
    const Example example;
    EXPECT_EQ(example.rays.size(), 32U * 32U);
    EXPECT_GT(example.hit_count, 100U);
    EXPECT_LT(example.hit_count, 32U * 32U);
}

TEST(ShadowRays, EndAtTheLight) {
    const Example example;
    const Vec3f light = place_light(example.camera, bounds_of(example.mesh.vertices));
    const auto rays = shadow_rays(example.mesh.view(), example.rays, example.hits, light);
    ASSERT_EQ(rays.size(), example.hit_count);
    for (const Ray& ray : rays) {
        EXPECT_EQ(ray.t_max, 1.0F);
        EXPECT_LE(length(to_double(ray.origin + ray.direction) - to_double(light)), 1e-4);
    }
}

TEST(SecondaryRays, StartOffTheSurfaceOnTheSideThatWasHit) {
    const Example example;
    const auto rays = diffuse_rays(example.mesh.view(), example.rays, example.hits, 1);
    std::size_t next = 0;
    for (std::size_t i = 0; i < example.rays.size(); ++i) {
        if (!std::isfinite(example.hits[i].t)) continue;
        const Triangle triangle = example.mesh.view().triangle(example.hits[i].prim);
        const Vec3d normal = cross(to_double(triangle[1]) - to_double(triangle[0]),
                                   to_double(triangle[2]) - to_double(triangle[0]));
        const double from = dot(normal, to_double(example.rays[i].origin) - to_double(triangle[0]));
        const Ray& ray = rays[next++];
        EXPECT_GT(from * dot(normal, to_double(ray.origin) - to_double(triangle[0])), 0.0);
        EXPECT_GT(from * dot(normal, to_double(ray.direction)), 0.0);
        EXPECT_NEAR(length(to_double(ray.direction)), 1.0, 1e-5);
    }
    EXPECT_EQ(next, rays.size());
}

TEST(DiffuseRays, AreDistributedAsTheCosine) {
    // A ground seen from above: the mean cosine of a cosine-weighted direction is 2/3.
    const TriangleMesh ground{{{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}},
                              {{0, 1, 2}, {0, 2, 3}}};
    const std::vector<Ray> rays(20000, Ray{{0, 5, 0}, {0, -1, 0}});
    const std::vector<Hit> hits(rays.size(), Hit{5.0F, 0.5F, 0.25F, 0});
    Vec3d sum;
    double square_sum = 0.0;
    for (const Ray& ray : diffuse_rays(ground.view(), rays, hits, 7)) {
        sum = sum + to_double(ray.direction);
        square_sum += static_cast<double>(ray.direction.y) * ray.direction.y;
    }
    const double count = 20000.0;
    EXPECT_NEAR(sum.x / count, 0.0, 0.02);
    EXPECT_NEAR(sum.y / count, 2.0 / 3.0, 0.01);
    EXPECT_NEAR(sum.z / count, 0.0, 0.02);
    EXPECT_NEAR(square_sum / count, 0.5, 0.01);
}

TEST(RaySets, DependOnTheirArgumentsAlone) {
    const Example a;
    const Example b;
    const auto diffuse = [](const Example& example, std::uint64_t seed) {
        return diffuse_rays(example.mesh.view(), example.rays, example.hits, seed);
    };
    EXPECT_TRUE(is_equal(a.rays, b.rays));
    EXPECT_TRUE(is_equal(diffuse(a, 5), diffuse(b, 5)));
    EXPECT_FALSE(is_equal(diffuse(a, 5), diffuse(a, 6)));
}

TEST(RaySets, AreEmptyWithoutHits) {
    const Example example;
    const std::vector<Hit> misses(example.rays.size());
    EXPECT_TRUE(shadow_rays(example.mesh.view(), example.rays, misses, {}).empty());
    EXPECT_TRUE(diffuse_rays(example.mesh.view(), example.rays, misses, 1).empty());
}

TEST(RaySets, TakeTrianglesWithoutArea) {
    const TriangleMesh line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
    const std::vector<Ray> rays{{{1, 1, 0}, {0, -1, 0}}};
    const std::vector<Hit> hits{{1.0F, 0.0F, 0.0F, 0}};
    const auto bounces = diffuse_rays(line.view(), rays, hits, 1);
    ASSERT_EQ(bounces.size(), 1U);
    EXPECT_TRUE(is_traceable(bounces[0]));
    EXPECT_GT(bounces[0].direction.y, 0.0F);
}

}  // namespace

}  // namespace coppice::lab
