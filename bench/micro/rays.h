#pragma once

#include "coppice/builders/build_tree.h"
#include "coppice/geom/ray.h"
#include "coppice/trace/bvh8_tracer.h"

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

/// The terrain's 8-wide tree, ready to be traced.
[[nodiscard]] inline const Bvh8Tracer& bvh8_tracer() {
    static const Bvh8Tracer tracer(build_bvh8(terrain().view()).tree);
    return tracer;
}

/// Runs `query(ray)` for each ray, again and again; items are rays.
template <typename Query>
void run_rays(benchmark::State& state, const Query& query) {
    const std::vector<Ray>& all = rays();
    for ([[maybe_unused]] const auto step : state) {
        for (const Ray& ray : all) {
            benchmark::DoNotOptimize(query(ray));
        }
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(all.size()));
}

/// The same of `query(tree, ray)` with the terrain's k-d tree from a sample of range(0) percent.
template <typename Query>
void run_rays_kd(benchmark::State& state, const Query& query) {
    const KdTree tree = build_kd_tree(terrain().view(), options_at(state.range(0))).tree;
    run_rays(state, [&](const Ray& ray) { return query(tree, ray); });
}

/// The same of `query(tracer, ray)` with the terrain's 8-wide tree.
template <typename Query>
void run_rays_bvh8(benchmark::State& state, const Query& query) {
    const Bvh8Tracer& tracer = bvh8_tracer();
    run_rays(state, [&](const Ray& ray) { return query(tracer, ray); });
}

/// Runs `query(tracer, threads)`, for all rays at once on range(0) threads; items are rays.
template <typename Query>
void run_batch(benchmark::State& state, const Query& query) {
    const Bvh8Tracer& tracer = bvh8_tracer();
    for ([[maybe_unused]] const auto step : state) {
        query(tracer, static_cast<int>(state.range(0)));
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays().size()));
}

/// What is measured of run_rays_kd().
inline void on_samples(benchmark::internal::Benchmark* measured) {
    measured->ArgName("percent")->Arg(1)->Arg(100)->Unit(benchmark::kMillisecond);
}

/// What is measured of run_batch().
inline void on_threads(benchmark::internal::Benchmark* measured) {
    measured->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
}

}  // namespace coppice::bench
