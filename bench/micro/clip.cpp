#include "coppice/geom/triangle.h"

#include "terrain.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace coppice::bench {
namespace {

// How a plane through the middle of each triangle's box cuts it.
enum class Cut { none, one_side, corner };

// Items are triangles, each clipped to its own box, to half of it or to an eighth.
void clip(benchmark::State& state, Cut cut) {
    const TriangleMeshView triangles = terrain().view();
    std::vector<Aabb> boxes;
    for (std::uint32_t id = 0; id < triangles.size(); ++id) {
        Aabb box = triangles.bounds(id);
        for (const Axis axis : all_axes) {
            const bool is_cut = cut == Cut::corner || (cut == Cut::one_side && axis == Axis::x);
            if (is_cut) box.upper[axis] = 0.5F * (box.lower[axis] + box.upper[axis]);
        }
        boxes.push_back(box);
    }
    for ([[maybe_unused]] const auto step : state) {
        for (std::uint32_t id = 0; id < triangles.size(); ++id) {
            benchmark::DoNotOptimize(clipped_triangle_bounds(triangles.triangle(id), boxes[id]));
        }
    }
    state.SetItemsProcessed(state.iterations() * triangles.size());
}

BENCHMARK_CAPTURE(clip, none, Cut::none)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(clip, half, Cut::one_side)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(clip, eighth, Cut::corner)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
