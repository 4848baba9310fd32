#pragma once

#include "coppice/geom/triangle_mesh.h"
#include "coppice/io/mesh_attributes.h"

#include "render/pixel_samples.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace coppice::render {

/// A lamp: a point or, with a radius, a ball that throws soft shadows. It does not fade with the
/// distance, as in [Whitted1980], so that it serves scenes of any size: a white surface that faces
/// it shows `brightness`. It is not seen itself.
struct Lamp {
    Vec3f position;
    double radius = 0.0;  ///< >= 0
    double brightness = 0.7;
};

/// What is seen where there is no surface: a colour, or if none is given a blue that fades to white
/// at the horizon and to grey below.
struct Sky {
    std::optional<Vec3f> color;
    Vec3f up{0.0F, 1.0F, 0.0F};

    /// The light that comes from a direction of unit length.
    [[nodiscard]] Vec3d radiance(Vec3d direction) const noexcept;
};

/// A point that lights a surface, drawn at random from all there are.
struct LightSample {
    Vec3f target;
    Vec3d direction;       ///< unit, from the surface to `target`
    Vec3d irradiance;      ///< on a surface that faces it, if nothing is between, over its density
    double density = 0.0;  ///< per solid angle; 0 for a lamp, which no other ray can find
};

/// The triangles that shine, and how to draw points on them in proportion to their power.
class Emitters {
public:
    Emitters() = default;

    /// All triangles whose material has an emission.
    Emitters(TriangleMeshView mesh, const MeshAttributes& attributes);

    [[nodiscard]] bool is_empty() const noexcept { return triangles_.empty(); }

    [[nodiscard]] std::uint64_t count() const noexcept { return triangles_.size(); }

    /// How dense the points drawn lie on an emitter of that emission, per area.
    [[nodiscard]] double area_density(Vec3f emission) const noexcept;

    /// A point of an emitter as seen from `position`; nothing if it cannot light it. Not if empty.
    [[nodiscard]] std::optional<LightSample> sample(Vec3d position, PixelSamples& random) const;

private:
    struct Emitter {
        Triangle corners;
        Vec3f emission;
        double power_before;  ///< of those before it
    };

    std::vector<Emitter> triangles_;
    double power_ = 0.0;  ///< of all: sum of area times luminance
};

/// A point of a lamp as seen from `position`.
[[nodiscard]] LightSample sample_lamp(const Lamp& lamp, Vec3d position, PixelSamples& random);

/// All light of a scene.
struct Lighting {
    std::optional<Lamp> lamp;
    Sky sky;
    Emitters emitters;

    /// Calls `take(LightSample)` for one point on each source of light that can light `position`.
    template <typename Take>
    void for_each_sample(Vec3d position, PixelSamples& random, const Take& take) const {
        if (lamp) take(sample_lamp(*lamp, position, random));
        if (emitters.is_empty()) return;
        if (const std::optional<LightSample> sample = emitters.sample(position, random)) {
            take(*sample);
        }
    }
};

}  // namespace coppice::render
