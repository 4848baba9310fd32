#pragma once

#include "coppice/geom/aabb.h"
#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/io/mesh_attributes.h"

#include "render/lighting.h"
#include "render/pixel_samples.h"
#include "tracers/traced_tree.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace coppice::render {

/// What is rendered. All of it must outlive the integrators at work on it.
struct View {
    const lab::TracedTree* tracer;
    TriangleMeshView mesh;
    const MeshAttributes* attributes;
    const Lighting* lighting;
};

/// How many rays of each kind were traced.
struct RayCounts {
    std::uint64_t primary = 0;     ///< from the camera
    std::uint64_t shadow = 0;      ///< to a light
    std::uint64_t reflection = 0;  ///< off a mirror
    std::uint64_t occlusion = 0;   ///< of `ao`
    std::uint64_t diffuse = 0;     ///< bounces of `path`
    TraversalCounts steps;         ///< what primary rays took, if it is counted (`cost`)

    RayCounts& operator+=(const RayCounts& other) noexcept;

    [[nodiscard]] std::uint64_t total() const noexcept {
        return primary + shadow + reflection + occlusion + diffuse;
    }
};

/// Serializes all fields under their own names, with the `total`.
void to_json(nlohmann::json& json, const RayCounts& counts);

/// What integrators can be told.
struct IntegratorOptions {
    int max_depth = 8;         ///< reflections and bounces in a row; >= 0
    double ao_distance = 1.0;  ///< what is further away does not occlude; > 0
};

/// Measures what a ray from the camera meets. Stateless: one serves all threads.
class Integrator {
public:
    Integrator() = default;
    Integrator(const Integrator&) = delete;
    Integrator& operator=(const Integrator&) = delete;
    virtual ~Integrator() = default;

    /// One sample of a pixel, by a ray with a direction of unit length. Counts the rays it traces.
    [[nodiscard]] virtual Vec3d sample(const View& view, const Ray& ray, PixelSamples& random,
                                       RayCounts& counts) const = 0;

    /// The pixel of a number of samples: their mean.
    [[nodiscard]] virtual Vec3d pixel_of(Vec3d sum, int sample_count) const noexcept {
        return (1.0 / sample_count) * sum;
    }
};

/// How an integrator's numbers become what a screen shows, see develop().
enum class Display {
    light,   ///< linear light: exposed, its highlights compressed, to sRGB
    share,   ///< in [0, 1], linear light: to sRGB
    normal,  ///< in [-1, 1], unchanged
    depth,   ///< near is bright; 0 is nothing, and black
    cost,    ///< heat_map()
};

/// An integrator under its name, with one line on what it shows.
struct IntegratorEntry {
    std::string_view name;
    std::string_view summary;
    Display display;
    std::unique_ptr<Integrator> (*make)(const IntegratorOptions& options);
};

/// All integrators.
[[nodiscard]] std::span<const IntegratorEntry> integrator_registry();

/// The integrator of that name. Throws Error(invalid_argument) naming those that exist.
[[nodiscard]] const IntegratorEntry& find_integrator(std::string_view name);

}  // namespace coppice::render
