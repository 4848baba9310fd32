// Measures methods with samples of several sizes in turns, and picks the one that finishes the rays
// asked for first: build + rays * seconds per ray. Which tree that is changes at the break-evens of
// pairs of trees (statistics/break_even.h).

#include "tune/tune.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"

#include "tracers/variant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coppice::lab {

namespace {

void check(const TuneOptions& options) {
    if (!(options.ray_count >= 1.0) || !std::isfinite(options.ray_count)) {
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("the number of rays is {}; it must be finite and at least 1",
                                options.ray_count));
    }
    if (options.percents.empty()) {
        throw Error(ErrorCode::invalid_argument, "no rate is given; give at least one percentage");
    }
}

/// Every method at every percentage, or at its own if it takes no sample.
std::vector<std::string> variants_of(const TuneOptions& options) {
    std::vector<std::string> variants;
    for (const std::string& method : options.methods) {
        const bool is_sampling = find_method(method).uses_sample();
        for (const double percent : options.percents) {
            if (is_sampling) variants.push_back(variant_name(method, percent));
        }
        if (!is_sampling) variants.push_back(method);
    }
    return variants;
}

BenchOptions bench_options(const TuneOptions& options) {
    return {.scenes = options.scenes,
            .methods = variants_of(options),
            .peers = {},
            .threads = {options.threads > 0 ? options.threads : hardware_thread_count()},
            .runs = options.runs,
            .rays = options.rays,
            .size = options.size,
            .camera = options.camera,
            .seed = options.seed,
            .memory_limit_bytes = options.memory_limit_bytes};
}

TuneRow make_row(const BenchScene& scene, const BenchRow& measured) {
    TuneRow row;
    row.method = find_variant(measured.method).method;
    row.sample_percent = 100.0 * measured.sample_share.value_or(1.0);
    row.measured = measured;
    double seconds = 0.0;
    double ray_count = 0.0;
    for (std::size_t i = 0; i < row.ray_seconds.size(); ++i) {
        if (!measured.mrays[i]) continue;
        row.ray_seconds[i] = 1e-6 / *measured.mrays[i];
        const auto count = static_cast<double>(scene.ray_counts[i]);
        seconds += count * *row.ray_seconds[i];
        ray_count += count;
    }
    if (ray_count == 0.0) {
        throw file_error(
            ErrorCode::unsupported, scene.file.string(),
            "the camera sees no surface that rays of these kinds could start from; give another "
            "--eye and --look-at");
    }
    row.time = {measured.build_seconds, seconds / ray_count};
    return row;
}

TuneResult make_result(const TuneOptions& options, const BenchScene& scene,
                       std::span<const BenchRow> rows) {
    TuneResult result{scene, {}, {}, 0};
    std::vector<TimeToImage> times;
    for (const BenchRow& measured : rows) {
        TuneRow row = make_row(scene, measured);
        const bool is_known =
            std::any_of(result.rows.begin(), result.rows.end(), [&](const TuneRow& other) {
                return other.method == row.method && other.sample_percent == row.sample_percent;
            });
        if (is_known) continue;
        times.push_back(row.time);
        result.rows.push_back(std::move(row));
    }
    result.fastest = best_spans(times);
    result.chosen = span_at(result.fastest, options.ray_count).index;
    return result;
}

}  // namespace

std::vector<TuneResult> run_tune(
    const TuneOptions& options,
    const std::function<void(const std::string&, std::optional<double>)>& on_progress) {
    check(options);
    std::vector<TuneResult> results;
    BenchObserver observer;
    observer.on_progress = on_progress;
    observer.on_scene = [&](const BenchScene& scene, std::span<const BenchRow> rows) {
        results.push_back(make_result(options, scene, rows));
    };
    static_cast<void>(run_bench(bench_options(options), observer));
    return results;
}

}  // namespace coppice::lab
