#include "coppice/trace/intersect.h"

#include "coppice/build/build_tree.h"
#include "coppice/geom/triangle.h"

#include "terrain.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace coppice::bench {
namespace {

// Rays from random points above the ground to random points below it, in no order.
std::vector<Ray> make_rays() {
    std::vector<Ray> rays;
    for (std::uint64_t i = 0; i < 16384; ++i) {
        const auto number = [&](std::uint64_t k) {
            return static_cast<float>(random_unit(2, 4 * i + k));
        };
        const Vec3f from{number(0), number(1), 0.5F};
        const Vec3f to{number(2), number(3), -0.5F};
        rays.push_back({.origin = from, .direction = to - from});
    }
    return rays;
}

KdTree tree_at(std::int64_t percent) {
    return build_kd_tree(terrain().view(), options_at(percent));
}

// Items are rays.
void closest_hit(benchmark::State& state) {
    const KdTree tree = tree_at(state.range(0));
    const std::vector<Ray> rays = make_rays();
    for ([[maybe_unused]] const auto step : state) {
        for (const Ray& ray : rays) {
            benchmark::DoNotOptimize(intersect(tree, terrain().view(), ray));
        }
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}

void any_hit(benchmark::State& state) {
    const KdTree tree = tree_at(state.range(0));
    const std::vector<Ray> rays = make_rays();
    for ([[maybe_unused]] const auto step : state) {
        for (const Ray& ray : rays) {
            benchmark::DoNotOptimize(occluded(tree, terrain().view(), ray));
        }
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}

// Items are single tests of a ray with a triangle, few of which hit.
void one_triangle(benchmark::State& state) {
    const std::vector<Ray> rays = make_rays();
    const TriangleMeshView triangles = terrain().view();
    for ([[maybe_unused]] const auto step : state) {
        for (std::uint32_t i = 0; i < rays.size(); ++i) {
            benchmark::DoNotOptimize(intersect_triangle(rays[i], triangles.triangle(i)));
        }
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}

BENCHMARK(closest_hit)->ArgName("percent")->Arg(1)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(any_hit)->ArgName("percent")->Arg(1)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(one_triangle)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
