#include "query_points.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <utility>

namespace coppice::bench {
namespace {

// A closed surface: the octahedron, each face cut into 64 x 64 triangles and bulged.
TriangleMesh make_ball() {
    constexpr int cells = 64;
    TriangleMesh mesh;
    const auto add = [&](Vec3f corner) {
        const double length = std::sqrt(static_cast<double>(dot(corner, corner)));
        mesh.vertices.push_back(static_cast<float>(1.0 / length) * corner);
        return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    };
    for (unsigned octant = 0; octant < 8; ++octant) {
        const auto sign = [&](unsigned axis) { return (octant >> axis & 1U) != 0 ? -1.0F : 1.0F; };
        const auto corner = [&](int i, int j) {
            const auto x = static_cast<float>(i);
            const auto y = static_cast<float>(j);
            return Vec3f{sign(0) * x, sign(1) * y, sign(2) * (cells - x - y)};
        };
        const bool is_mirrored = sign(0) * sign(1) * sign(2) < 0.0F;
        const auto add_triangle = [&](Vec3f a, Vec3f b, Vec3f c) {
            if (is_mirrored) std::swap(b, c);
            const std::uint32_t first = add(a);
            mesh.triangles.push_back({first, add(b), add(c)});
        };
        for (int i = 0; i < cells; ++i) {
            for (int j = 0; i + j < cells; ++j) {
                add_triangle(corner(i, j), corner(i + 1, j), corner(i, j + 1));
                if (i + j + 1 == cells) continue;
                add_triangle(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
            }
        }
    }
    return mesh;
}

// Items are queries.
void signed_distance(benchmark::State& state) {
    const SignedDistance surface = Scene(make_ball()).make_signed_distance();
    for ([[maybe_unused]] const auto step : state) {
        for (const Vec3f& point : query_points()) {
            benchmark::DoNotOptimize(surface.nearest(point));
        }
    }
    count_queries(state);
}

// Items are triangles.
void make_signed_distance(benchmark::State& state) {
    const Scene scene(make_ball());
    for ([[maybe_unused]] const auto step : state) {
        benchmark::DoNotOptimize(scene.make_signed_distance());
    }
    state.SetItemsProcessed(state.iterations() * scene.mesh().view().size());
}

BENCHMARK(signed_distance)->Unit(benchmark::kMillisecond);
BENCHMARK(make_signed_distance)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
