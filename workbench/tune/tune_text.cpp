#include "scenes/camera.h"
#include "text/numbers.h"
#include "tune/tune.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coppice::lab {

namespace {

constexpr double near_share = 0.03;  // closer than medians of a few runs can tell apart, ever

constexpr const char* tune_line =
    "{:1} {:<10} {:>8} {:>9} {:>9} {:>8} {:>8} {:>8} {:>8} {:>10}  {}\n";

std::string nanoseconds_text(const std::optional<double>& seconds) {
    return fixed_text(seconds ? std::optional(1e9 * *seconds) : std::nullopt, 1);
}

std::string short_text(double count) {
    return fmt::format("{:.3g}", count);
}

std::string rays_text(double count) {
    return short_text(count) + (count == 1.0 ? " ray" : " rays");
}

std::string percent_text(double percent) {
    return fmt::format("{:.3g} %", percent);
}

/// "fast from a sample of 1 %"
std::string name_text(const TuneRow& row) {
    if (row.sample_percent >= 100.0) return fmt::format("`{}` without sampling", row.method);
    return fmt::format("`{}` from a sample of {}", row.method, percent_text(row.sample_percent));
}

std::string row_text(const TuneOptions& options, const TuneResult& result, std::size_t index) {
    const TuneRow& row = result.rows[index];
    const auto span = std::find_if(result.fastest.begin(), result.fastest.end(),
                                   [&](const BestSpan& best) { return best.index == index; });
    return fmt::format(tune_line, index == result.chosen ? "*" : "", row.method,
                       percent_text(row.sample_percent), seconds_text(row.time.build),
                       seconds_text(row.measured.build_cpu_seconds),
                       nanoseconds_text(row.ray_seconds[0]), nanoseconds_text(row.ray_seconds[1]),
                       nanoseconds_text(row.ray_seconds[2]), nanoseconds_text(row.time.ray),
                       seconds_text(row.time.seconds(options.ray_count)),
                       span == result.fastest.end() ? "" : span_text(*span));
}

/// Why not the one that builds sooner, nor the one whose rays are faster.
std::string reason_text(const TuneResult& result) {
    const TimeToImage& chosen = result.rows[result.chosen].time;
    const auto at = std::find_if(result.fastest.begin(), result.fastest.end(),
                                 [&](const BestSpan& span) { return span.index == result.chosen; });
    if (result.rows.size() == 1) return "; nothing else was measured";
    if (result.fastest.size() == 1) return "; nothing else builds faster or traces faster";
    std::string text;
    if (at != result.fastest.begin()) {
        const TuneRow& sooner = result.rows[(at - 1)->index];
        text += fmt::format(
            "; {} builds {} s sooner, but a ray takes {:.1f} % longer, so that it is faster only "
            "up to {} rays",
            name_text(sooner), seconds_text(chosen.build - sooner.time.build),
            100.0 * (sooner.time.ray / chosen.ray - 1.0), short_text(at->from));
    }
    if (at + 1 != result.fastest.end()) {
        const TuneRow& later = result.rows[(at + 1)->index];
        text += fmt::format(
            "; {} traces a ray in {:.1f} % less time, but builds {} s longer, which pays only "
            "from {} rays",
            name_text(later), 100.0 * (1.0 - later.time.ray / chosen.ray),
            seconds_text(later.time.build - chosen.build), short_text(at->to));
    }
    return text;
}

/// The rows that are nearly as fast.
std::string near_text(const TuneOptions& options, const TuneResult& result) {
    const double best = result.rows[result.chosen].time.seconds(options.ray_count);
    const double noise = std::max(near_share, result.rows[result.chosen].measured.scatter);
    std::string names;
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
        const bool is_near = result.rows[i].time.seconds(options.ray_count) <= (1.0 + noise) * best;
        if (i == result.chosen || !is_near) continue;
        names += (names.empty() ? "" : ", ") + name_text(result.rows[i]);
    }
    if (names.empty()) return {};
    return fmt::format("; within {:.0f} % of it, which is noise: {}", 100.0 * noise, names);
}

}  // namespace

std::string tune_table(const TuneOptions& options, const TuneResult& result) {
    std::string text = fmt::format(
        "{}: {} triangles; {} primary, {} shadow, {} diffuse rays; {}, medians of {}\n",
        result.scene.scene, result.scene.triangles, result.scene.ray_counts[0],
        result.scene.ray_counts[1], result.scene.ray_counts[2],
        count_text(static_cast<std::uint64_t>(result.rows[0].measured.threads), "thread"),
        count_text(static_cast<std::uint64_t>(options.runs), "run"));
    text += fmt::format("rays from {}\n", render::camera_text(result.scene.camera));
    text += fmt::format(tune_line, "", "", "", "build", "CPU", "primary", "shadow", "diffuse",
                        "a ray", rays_text(options.ray_count), "");
    text += fmt::format(tune_line, "", "method", "sample", "s", "s", "ns", "ns", "ns", "ns", "s",
                        "fastest");
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
        text += row_text(options, result, i);
    }
    return text;
}

std::string tune_sentence(const TuneOptions& options, const TuneResult& result) {
    const TuneRow& chosen = result.rows[result.chosen];
    return fmt::format("{}: for {} use {}: with {} s to build and {} ns a ray they take {} s{}{}.",
                       result.scene.scene, rays_text(options.ray_count), name_text(chosen),
                       seconds_text(chosen.time.build), nanoseconds_text(chosen.time.ray),
                       seconds_text(chosen.time.seconds(options.ray_count)), reason_text(result),
                       near_text(options, result));
}

}  // namespace coppice::lab
