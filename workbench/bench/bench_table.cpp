#include "bench/bench_results.h"
#include "text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace coppice::lab {

namespace {

constexpr const char* bench_line =
    "{:<14} {:>7} {:>9} {:>9} {:>9} {:>7} {:>7} {:>8} {:>7} {:>8} {:>8} {:>8} {:>10}\n";

constexpr const char* ratio_format = "{:<14} {:>7} {:<14} {:>8} {:>8} {:>8} {:>8}\n";

std::string row_text(const BenchRow& row) {
    return fmt::format(bench_line, row.method, row.threads, seconds_text(row.build_seconds),
                       seconds_text(row.build_seconds_first), seconds_text(row.build_cpu_seconds),
                       fixed_text(row.bytes_per_triangle, 1),
                       fixed_text(row.peak_bytes_per_triangle, 1), fixed_text(row.sah_cost, 2),
                       fixed_text(row.references_per_triangle, 2), fixed_text(row.mrays[0], 2),
                       fixed_text(row.mrays[1], 2), fixed_text(row.mrays[2], 2), row.mismatches);
}

/// How many times faster a row is than its peers in the same run: building, then the ray kinds.
struct Ratios {
    std::string scene;
    std::string method;
    int threads;
    std::array<std::optional<double>, 4> values;
};

const BenchRow* find_row(std::span<const BenchRow> rows, const BenchRow& beside,
                         std::string_view method) {
    const auto at = std::find_if(rows.begin(), rows.end(), [&](const BenchRow& row) {
        return row.scene == beside.scene && row.threads == beside.threads && row.method == method;
    });
    return at == rows.end() ? nullptr : &*at;
}

Ratios ratios_of(std::span<const BenchRow> rows, const BenchRow& row, std::string_view builder,
                 std::string_view tracer) {
    Ratios ratios{row.scene, row.method, row.threads, {}};
    const BenchRow* built = find_row(rows, row, builder);
    const BenchRow* traced = find_row(rows, row, tracer);
    if (built != nullptr) ratios.values[0] = built->build_seconds / row.build_seconds;
    for (std::size_t i = 0; i < row.mrays.size(); ++i) {
        if (traced != nullptr && traced->mrays[i] && row.mrays[i]) {
            ratios.values[i + 1] = *row.mrays[i] / *traced->mrays[i];
        }
    }
    return ratios;
}

std::optional<double> geometric_mean(std::span<const Ratios> all, std::size_t column) {
    double log_sum = 0.0;
    int count = 0;
    for (const Ratios& ratios : all) {
        if (!ratios.values[column]) continue;
        log_sum += std::log(*ratios.values[column]);
        ++count;
    }
    return count == 0 ? std::nullopt : std::optional(std::exp(log_sum / count));
}

std::string ratios_text(const Ratios& ratios) {
    return fmt::format(ratio_format, ratios.method, ratios.threads, ratios.scene,
                       fixed_text(ratios.values[0], 2), fixed_text(ratios.values[1], 2),
                       fixed_text(ratios.values[2], 2), fixed_text(ratios.values[3], 2));
}

/// All scenes of one method and number of threads, with their mean.
std::string group_text(std::span<const Ratios> group) {
    std::string text;
    for (const Ratios& ratios : group) {
        text += ratios_text(ratios);
    }
    Ratios mean{"geometric mean", group.front().method, group.front().threads, {}};
    for (std::size_t i = 0; i < mean.values.size(); ++i) {
        mean.values[i] = geometric_mean(group, i);
    }
    return group.size() > 1 ? text + ratios_text(mean) : text;
}

bool has_method(std::span<const BenchRow> rows, std::string_view method) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const BenchRow& row) { return row.method == method; });
}

std::string ratio_block(std::span<const BenchRow> rows, std::string_view builder,
                        std::string_view tracer) {
    std::vector<Ratios> all;
    for (const BenchRow& row : rows) {
        if (!row.is_peer) all.push_back(ratios_of(rows, row, builder, tracer));
    }
    std::stable_sort(all.begin(), all.end(), [](const Ratios& a, const Ratios& b) {
        return std::tie(a.method, a.threads) < std::tie(b.method, b.threads);
    });
    std::string text = fmt::format(
        "Times faster than in the same run: building than {}, tracing than {}\n", builder, tracer);
    text += fmt::format(ratio_format, "method", "threads", "scene", "build", "primary", "shadow",
                        "diffuse");
    for (auto first = all.begin(); first != all.end();) {
        const auto last = std::find_if(first, all.end(), [&](const Ratios& ratios) {
            return ratios.method != first->method || ratios.threads != first->threads;
        });
        text += group_text({first, last});
        first = last;
    }
    return text;
}

}  // namespace

std::string bench_table(const BenchScene& scene, std::span<const BenchRow> rows) {
    const auto point = [](Vec3f v) {
        return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z);
    };
    std::string text = fmt::format(
        "{}: {} triangles; seen from {} towards {}, light at {}\n"
        "rays: {} primary, {} shadow, {} diffuse; hits compared with {}\n",
        scene.scene, scene.triangles, point(scene.camera.eye), point(scene.camera.look_at),
        point(scene.light), scene.ray_counts[0], scene.ray_counts[1], scene.ray_counts[2],
        scene.reference);
    text += fmt::format(bench_line, "", "", "build", "first", "CPU", "bytes/", "peak/", "", "refs/",
                        "primary", "shadow", "diffuse", "");
    text += fmt::format(bench_line, "method", "threads", "s", "s", "s", "tri", "tri", "cost", "tri",
                        "Mrays/s", "Mrays/s", "Mrays/s", "mismatches");
    for (const BenchRow& row : rows) {
        text += row_text(row);
    }
    return text;
}

std::string ratio_table(std::span<const BenchRow> rows) {
    constexpr std::string_view builder = "embree-medium";
    std::string text;
    const bool has_ours =
        std::any_of(rows.begin(), rows.end(), [](const BenchRow& row) { return !row.is_peer; });
    if (!has_ours) return text;
    if (has_method(rows, builder) || has_method(rows, "embree-high")) {
        text += ratio_block(rows, builder, "embree-high");
    }
    if (has_method(rows, "embree-robust")) {
        if (!text.empty()) text += '\n';
        text += ratio_block(rows, builder, "embree-robust");
    }
    return text;
}

}  // namespace coppice::lab
