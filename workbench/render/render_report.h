#pragma once

#include "coppice/builders/build_report.h"
#include "coppice/builders/method.h"

#include "render/lighting.h"
#include "render/render.h"
#include "scenes/camera.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::render {

/// What `coppice render` did, without the image.
struct RenderReport {
    std::string scene;  ///< its name
    std::string file;
    std::uint32_t triangle_count = 0;
    std::uint64_t emitter_count = 0;  ///< triangles that shine
    double load_seconds = 0.0;
    TreeKind tree = TreeKind::bvh8;
    BuildReport build;
    std::string tree_file;           ///< if the tree was not built but loaded, of `build.method`
    double tree_load_seconds = 0.0;  ///< then
    std::string integrator;
    IntegratorOptions integrator_options;
    RenderOptions options;
    int threads = 1;  ///< that were used
    Camera camera;
    bool is_camera_chosen = false;  ///< rather than given
    bool is_camera_inside = false;  ///< chosen within a room
    std::optional<Lamp> lamp;
    bool is_lamp_chosen = false;
    std::optional<Vec3f> sky;  ///< if it is of one colour
    RayCounts rays;
    std::uint64_t pixel_count = 0;  ///< that are done
    double trace_seconds = 0.0;
    std::optional<double> cost_scale;  ///< of the heat map, if it is one
    std::string output;
    std::vector<std::string> warnings;

    [[nodiscard]] double build_seconds() const noexcept { return build.stages.wall_seconds(); }

    /// Millions of rays a second, of all kinds together; 0 if no time has passed.
    [[nodiscard]] double mrays_per_second() const noexcept;
};

/// The report as lines of text, without the path of the image.
[[nodiscard]] std::string render_text(const RenderReport& report);

/// Serializes all fields under their own names, and `mrays_per_second`.
void to_json(nlohmann::json& json, const RenderReport& report);

}  // namespace coppice::render
