#include "render/render_report.h"

#include "coppice/json/build_report.h"

#include "text/numbers.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <string_view>
#include <utility>

namespace coppice::render {

namespace {

std::string lamp_text(const RenderReport& report) {
    if (!report.lamp) return report.emitter_count > 0 ? "the scene's own" : "none but the sky";
    std::string text = "--light=" + vector_text(report.lamp->position);
    if (report.lamp->radius > 0.0) text += fmt::format(" --light-radius={}", report.lamp->radius);
    if (report.is_lamp_chosen) text += "  (chosen)";
    return text;
}

std::string rays_text(const RayCounts& rays) {
    const std::array<std::pair<std::uint64_t, std::string_view>, 5> kinds{{
        {rays.primary, "primary"},
        {rays.shadow, "shadow"},
        {rays.reflection, "reflection"},
        {rays.occlusion, "occlusion"},
        {rays.diffuse, "diffuse"},
    }};
    std::string text;
    for (const auto& [count, name] : kinds) {
        if (count == 0) continue;
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", lab::grouped_text(count), name);
    }
    return text.empty() ? "none" : text;
}

/// Steps of a ray on average, of those that were counted.
double per_ray(std::uint64_t steps, const RayCounts& rays) {
    return rays.primary > 0 ? static_cast<double>(steps) / static_cast<double>(rays.primary) : 0.0;
}

std::string steps_text(const RenderReport& report) {
    const TraversalCounts& steps = report.rays.steps;
    return fmt::format(
        "  steps   {:.2f} inner nodes, {:.2f} leaves, {:.2f} primitives a ray; --cost-scale={}\n",
        per_ray(steps.nodes, report.rays), per_ray(steps.leaves, report.rays),
        per_ray(steps.primitives, report.rays), *report.cost_scale);
}

nlohmann::json steps_json(const RenderReport& report) {
    if (!report.cost_scale) return nullptr;
    const TraversalCounts& steps = report.rays.steps;
    return {{"nodes_per_ray", per_ray(steps.nodes, report.rays)},
            {"leaves_per_ray", per_ray(steps.leaves, report.rays)},
            {"primitives_per_ray", per_ray(steps.primitives, report.rays)},
            {"scale", *report.cost_scale}};
}

nlohmann::json array_of(Vec3f v) {
    return nlohmann::json::array({v.x, v.y, v.z});
}

nlohmann::json lamp_json(const RenderReport& report) {
    if (!report.lamp) return nullptr;
    return {{"position", array_of(report.lamp->position)},
            {"radius", report.lamp->radius},
            {"chosen", report.is_lamp_chosen}};
}

const char* tree_name(TreeKind kind) {
    return kind == TreeKind::kd ? "k-d tree" : "8-wide tree";
}

std::string tree_text(const RenderReport& report) {
    if (!report.tree_file.empty()) {
        return fmt::format("{}, {}, loaded from {} in {:.3f} s", report.build.method,
                           tree_name(report.tree), report.tree_file, report.tree_load_seconds);
    }
    return fmt::format("{}, {}, built in {:.3f} s, SAH cost {:.2f}", report.build.method,
                       tree_name(report.tree), report.build_seconds(),
                       report.build.statistics.sah_cost);
}

}  // namespace

double RenderReport::mrays_per_second() const noexcept {
    return trace_seconds > 0.0 ? 1e-6 * static_cast<double>(rays.total()) / trace_seconds : 0.0;
}

std::string render_text(const RenderReport& report) {
    std::string text = fmt::format("{}: {} triangles, loaded in {:.2f} s\n", report.scene,
                                   lab::grouped_text(report.triangle_count), report.load_seconds);
    text += fmt::format("  tree    {}\n", tree_text(report));
    const char* const choice = report.is_camera_inside
                                   ? "  (chosen, inside: from outside there are only walls)"
                                   : "  (chosen)";
    text += fmt::format("  camera  {}{}\n", camera_text(report.camera),
                        report.is_camera_chosen ? choice : "");
    text += fmt::format("  light   {}\n", lamp_text(report));
    text += fmt::format("  image   {} x {} pixels of {} samples, {}, seed {}, {} threads\n",
                        report.options.width, report.options.height, report.options.samples,
                        report.integrator, report.options.seed, report.threads);
    text += fmt::format("  rays    {}\n", rays_text(report.rays));
    text += fmt::format("  traced  {} rays in {:.2f} s, {:.2f} Mrays/s\n",
                        lab::grouped_text(report.rays.total()), report.trace_seconds,
                        report.mrays_per_second());
    if (report.cost_scale) text += steps_text(report);
    return text;
}

void to_json(nlohmann::json& json, const RenderReport& report) {
    nlohmann::json camera = report.camera;
    camera["chosen"] = report.is_camera_chosen;
    camera["inside"] = report.is_camera_inside;
    const auto pixels = static_cast<std::uint64_t>(report.options.width) *
                        static_cast<std::uint64_t>(report.options.height);
    json = {{"scene", report.scene},
            {"file", report.file},
            {"triangle_count", report.triangle_count},
            {"emitter_count", report.emitter_count},
            {"load_seconds", report.load_seconds},
            {"build_seconds", report.build_seconds()},
            {"trace_seconds", report.trace_seconds},
            {"mrays_per_second", report.mrays_per_second()},
            {"method", report.build.method},
            {"tree", report.tree == TreeKind::kd ? "kd" : "bvh8"},
            {"integrator", report.integrator},
            {"max_depth", report.integrator_options.max_depth},
            {"ao_distance", report.integrator_options.ao_distance},
            {"width", report.options.width},
            {"height", report.options.height},
            {"samples", report.options.samples},
            {"seed", report.options.seed},
            {"threads", report.threads},
            {"camera", camera},
            {"light", lamp_json(report)},
            {"sky", report.sky ? array_of(*report.sky) : nlohmann::json(nullptr)},
            {"rays", report.rays},
            {"cost", steps_json(report)},
            {"complete", report.pixel_count == pixels},
            {"pixel_count", report.pixel_count},
            {"output", report.output},
            {"warnings", report.warnings},
            {"build", report.build}};
    if (report.tree_file.empty()) return;
    json["build"] = nullptr;
    json["tree_file"] = report.tree_file;
    json["tree_load_seconds"] = report.tree_load_seconds;
}

}  // namespace coppice::render
