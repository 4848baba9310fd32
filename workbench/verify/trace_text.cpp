// What a run of `coppice trace` says on the terminal.

#include "verify/trace_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coppice::lab {

namespace {

std::string point_text(Vec3f v) {
    return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z);
}

std::string speed_text(const TraceRow& row) {
    if (!(row.seconds > 0.0)) return "-";
    return fmt::format("{:.2f}", 1e-6 * static_cast<double>(row.rays) / row.seconds);
}

std::string speed_table(const TraceScene& scene) {
    std::string text = fmt::format("{:<10} {:>10} {:>10} {:>9}\n", "", "rays", "hits", "Mrays/s");
    for (const TraceRow& row : scene.rows) {
        text += fmt::format("{:<10} {:>10} {:>10} {:>9}\n", name_of(row.kind), row.rays, row.hits,
                            speed_text(row));
    }
    return text;
}

std::string count_table(const TraceScene& scene) {
    constexpr const char* line = "{:<10} {:<10} {:>10} {:>8} {:>8} {:>8} {:>8}\n";
    std::string text =
        '\n' + fmt::format(line, "a ray", "visits", "mean", "50 %", "90 %", "99 %", "most");
    for (const TraceRow& row : scene.rows) {
        if (!row.counts) continue;
        const auto add = [&](const char* what, const Distribution& of) {
            text += fmt::format(line, name_of(row.kind), what, fmt::format("{:.2f}", of.mean),
                                of.p50, of.p90, of.p99, of.max);
        };
        add("nodes", row.counts->nodes);
        add("leaves", row.counts->leaves);
        add("primitives", row.counts->primitives);
    }
    return text;
}

std::string answer_text(const Hit& hit, RayKind kind) {
    if (!hit.is_hit()) return "no hit";
    if (kind == RayKind::shadow) return "a hit";
    return fmt::format("triangle {} at {:.9g}", hit.prim, hit.t);
}

std::string truth_text(const std::optional<ExactHit>& exact) {
    return exact ? fmt::format("triangle {} at {:.17g}", exact->prim, exact->t) : "no hit";
}

std::string verdict_text(bool is_right) {
    return is_right ? "right" : "wrong";
}

std::string difference_text(const TraceDifference& difference, RayKind kind,
                            std::string_view reference) {
    const Ray& ray = difference.ray;
    return fmt::format(
        "  {} ray {}: from {} towards {}, t in [{:.9g}, {:.9g}]\n"
        "    ours:   {}, {}\n"
        "    {:<7} {}, {}\n"
        "    exact:  {}\n",
        name_of(kind), difference.index, point_text(ray.origin), point_text(ray.direction),
        ray.t_min, ray.t_max, answer_text(difference.ours, kind),
        verdict_text(difference.is_ours_right), fmt::format("{}:", reference),
        answer_text(difference.reference, kind), verdict_text(difference.is_reference_right),
        truth_text(difference.exact));
}

std::string comparison_table(const TraceOptions& options, const TraceScene& scene) {
    const std::string reference = std::string(name_of(options.check));
    constexpr const char* line = "{:<10} {:>8} {:>9} {:>9} {:>11} {:>12} {:>11}\n";
    std::string text = '\n' + fmt::format(line, "compared", "ties", "hit/miss", "distance",
                                          "ours right", reference + " right", "ours wrong");
    for (const TraceRow& row : scene.rows) {
        if (!row.comparison) continue;
        const TraceComparison& with = *row.comparison;
        text += fmt::format(line, name_of(row.kind), with.ties, with.hit_miss, with.distance,
                            with.ours_right, with.reference_right, with.ours_wrong);
    }
    for (const TraceRow& row : scene.rows) {
        if (!row.comparison || row.comparison->examples.empty()) continue;
        const std::uint64_t count = row.comparison->hit_miss + row.comparison->distance;
        text += fmt::format("\n{} of {} {} rays that differ, and what exact arithmetic finds:\n",
                            row.comparison->examples.size(), count, name_of(row.kind));
        for (const TraceDifference& difference : row.comparison->examples) {
            text += difference_text(difference, row.kind, reference);
        }
    }
    return text;
}

}  // namespace

std::string trace_text(const TraceOptions& options, const TraceScene& scene) {
    std::string text = fmt::format("{}: {} triangles; {} {} in {:.3g} s; seen from {} towards {}\n",
                                   scene.scene, scene.triangles, scene.method,
                                   options.tree.empty() ? "built" : "loaded", scene.build_seconds,
                                   point_text(scene.camera.eye), point_text(scene.camera.look_at));
    text += speed_table(scene);
    if (options.counts) text += count_table(scene);
    if (options.check != TraceCheck::none) text += comparison_table(options, scene);
    return text;
}

}  // namespace coppice::lab
