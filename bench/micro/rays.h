#pragma once

#include "coppice/build/build_tree.h"
#include "coppice/geom/ray.h"
#include "coppice/trace/wide_tracer.h"

#include "terrain.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

namespace coppice::bench {

[[nodiscard]] inline std::vector<Ray> make_rays() {
    std::vector<Ray> made;
    for (std::uint64_t i = 0; i < 16384; ++i) {
        const auto number = [&](std::uint64_t k) {
            return static_cast<float>(random_unit(2, 4 * i + k));
        };
        const Vec3f from{number(0), number(1), 0.5F};
        const Vec3f to{number(2), number(3), -0.5F};
        made.push_back({.origin = from, .direction = to - from});
    }
    return made;
}

/// 16,384 rays from random points above the terrain to random points below it, in no order.
[[nodiscard]] inline const std::vector<Ray>& rays() {
    static const std::vector<Ray> made = make_rays();
    return made;
}

/// The terrain's k-d tree from a sample of as many percent.
[[nodiscard]] inline KdTree kd_tree_at(std::int64_t percent) {
    return build_kd_tree(terrain().view(), options_at(percent));
}

/// The terrain's wide tree, ready to be traced.
[[nodiscard]] inline const WideTracer& wide_tracer() {
    static const WideTracer tracer(build_wide_bvh(terrain().view()));
    return tracer;
}

/// Runs `query(ray)` for each ray, again and again; items are rays.
template <typename Query>
void run_rays(benchmark::State& state, const Query& query) {
    for ([[maybe_unused]] const auto step : state) {
        for (const Ray& ray : rays()) {
            benchmark::DoNotOptimize(query(ray));
        }
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays().size()));
}

/// Runs `query()` for all rays at once; items are rays.
template <typename Query>
void run_batch(benchmark::State& state, const Query& query) {
    for ([[maybe_unused]] const auto step : state) {
        query();
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays().size()));
}

}  // namespace coppice::bench
