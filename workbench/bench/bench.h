#pragma once

#include "bench/bench_options.h"
#include "bench/bench_results.h"

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace coppice::lab {

/// Callbacks of a benchmark. Empty ones are not called.
struct BenchObserver {
    /// What runs now, and how long all that is planned will still take, once it can be told.
    std::function<void(const std::string& step, std::optional<double> remaining_seconds)>
        on_progress;
    std::function<void(const BenchScene& scene, std::span<const BenchRow> rows)> on_scene;
};

/// Runs a benchmark. For every scene and number of threads: a first round, in which each contestant
/// builds (the first touch), and its hits are compared with the reference's, embree-robust's if
/// that takes part, else those of the first contestant; then `runs` rounds, in which the
/// contestants take turns, ours and peers alternately: each builds, traces all rays and is freed.
/// The rays are made once, from the reference's hits, and all contestants trace the same.
/// Throws Error(invalid_argument) for options out of range, Error(unsupported) for a scene without
/// triangles, Error(limit) for a build that would pass the memory limit, and like load_mesh().
[[nodiscard]] BenchResult run_bench(const BenchOptions& options,
                                    const BenchObserver& observer = {});

}  // namespace coppice::lab
