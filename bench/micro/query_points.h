#pragma once

#include "coppice/scene/point_scene.h"
#include "coppice/scene/scene.h"

#include "terrain.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

namespace coppice::bench {

[[nodiscard]] inline std::vector<Vec3f> make_query_points() {
    std::vector<Vec3f> made;
    for (std::uint64_t i = 0; i < 4096; ++i) {
        const auto number = [&](std::uint64_t k) {
            return static_cast<float>(random_unit(3, 3 * i + k));
        };
        made.push_back({number(0), number(1), 0.2F * number(2) - 0.1F});
    }
    return made;
}

/// 4,096 points in the box of the terrain, in no order, the same each time.
[[nodiscard]] inline const std::vector<Vec3f>& query_points() {
    static const std::vector<Vec3f> points = make_query_points();
    return points;
}

/// The terrain, ready to be searched.
[[nodiscard]] inline const Scene& terrain_scene() {
    static const Scene scene(terrain());
    return scene;
}

/// Its corners.
[[nodiscard]] inline const PointScene& corner_scene() {
    static const PointScene scene(terrain().vertices);
    return scene;
}

/// Counts the items of a run: queries.
inline void count_queries(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(query_points().size()));
}

}  // namespace coppice::bench
