#pragma once

#include "bench/bench.h"
#include "statistics/break_even.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace coppice::lab {

/// What to choose a builder from, and for how many rays.
struct TuneOptions {
    std::vector<std::filesystem::path> scenes;
    double ray_count = 1e8;  ///< that will be traced with the tree; finite, >= 1
    std::vector<std::string> methods{"binned", "sampled", "fast", "balanced", "quality"};
    std::vector<double> percents{1, 10, 100};  ///< distinct, in (0, 100]; of methods that sample
    int threads = 0;                           ///< 0 = all the hardware has
    int runs = 3;                              ///< measured builds after the first
    std::vector<RayKind> rays{RayKind::primary, RayKind::shadow, RayKind::diffuse};
    int size = 512;                        ///< of the image, in pixels each way
    render::CameraWish camera;             ///< for all scenes
    std::uint64_t seed = 1;                ///< of the bounces' directions
    std::uint64_t memory_limit_bytes = 0;  ///< of a scene and a build of ours; 0: none
};

/// A method with a sample, and what an image costs with it.
struct TuneRow {
    std::string method;
    double sample_percent = 100.0;  ///< that was really drawn
    BenchRow measured;
    std::array<std::optional<double>, 3> ray_seconds;  ///< of one ray, by RayKind
    TimeToImage time;  ///< wall clock; a ray of the kinds in their numbers of one image
};

/// What was found out about a scene.
struct TuneResult {
    BenchScene scene;
    std::vector<TuneRow> rows;      ///< at least one
    std::vector<BestSpan> fastest;  ///< by number of rays
    std::size_t chosen = 0;         ///< the row that is fastest for the rays asked for
};

/// Measures all methods at all percentages as run_bench() does, and tells which one is the fastest
/// for so many rays. Methods that take no sample are measured once; of percentages that come to the
/// same sample (8-wide trees of small scenes have none) only the first is kept.
/// Throws Error(invalid_argument) for options out of range, Error(unsupported) for a scene where no
/// ray of these kinds can be made, and like run_bench().
[[nodiscard]] std::vector<TuneResult> run_tune(
    const TuneOptions& options,
    const std::function<void(const std::string& step, std::optional<double> remaining_seconds)>&
        on_progress = {});

/// All rows of a scene as plain text.
[[nodiscard]] std::string tune_table(const TuneOptions& options, const TuneResult& result);

/// Which builder and rate to use, and why: one sentence.
[[nodiscard]] std::string tune_sentence(const TuneOptions& options, const TuneResult& result);

/// The JSON of a run: `machine`, `options`, and `scenes` with `answer`, `recommended`, `rows`,
/// `fastest` and `break_even` of every pair of rows that has one.
[[nodiscard]] nlohmann::ordered_json tune_document(const TuneOptions& options,
                                                   std::span<const TuneResult> results);

}  // namespace coppice::lab
