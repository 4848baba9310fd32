// Whitted's integrator: at each hit one shadow ray per source of light, the material's diffuse and
// highlight terms, a little ambient light, and on mirrors the reflection, which is the same again.
// There is at most one reflection ray a hit, so the recursion is a loop.
// Source: [Whitted1980], [Phong1975] (highlights).

#include "render/integrators/integrators.h"
#include "render/integrators/shading.h"

#include <cmath>
#include <numbers>

namespace coppice::render {

namespace {

constexpr double ambient = 0.15;  // of the diffuse colour

class Whitted : public Integrator {
public:
    explicit Whitted(int max_depth) : max_depth_(max_depth) {}

    [[nodiscard]] Vec3d sample(const View& view, const Ray& primary, PixelSamples& random,
                               RayCounts& counts) const override {
        Ray ray = primary;
        ++counts.primary;
        Vec3d light;
        Vec3d share{1.0, 1.0, 1.0};  // of what the ray brings that reaches the camera
        for (int depth = 0;; ++depth) {
            const Vec3d direction = to_double(ray.direction);
            const std::optional<Hit> hit = view.tracer->intersect(ray);
            if (!hit) return light + product(share, view.lighting->sky.radiance(direction));
            const Surface surface = surface_at(view.mesh, *view.attributes, ray, *hit);
            light = light + product(share, shade(view, surface, direction, random, counts));
            if (depth == max_depth_ || !is_mirror(*surface.material)) return light;
            share = product(share, to_double(surface.material->specular));
            ray = mirror_ray(surface, direction);
            ++counts.reflection;
        }
    }

private:
    /// The light that a surface sends back along `direction`, without reflections.
    static Vec3d shade(const View& view, const Surface& surface, Vec3d direction,
                       PixelSamples& random, RayCounts& counts) {
        const Material& material = *surface.material;
        const Vec3d diffuse = to_double(material.diffuse);
        const bool has_highlights = material.illumination >= 2 && material.shininess > 0.0F;
        const Vec3d reflected = mirrored(direction, surface.normal);
        Vec3d light = to_double(material.emission) + ambient * diffuse;
        for_each_visible_light(
            view, surface, random, counts, [&](const LightSample& sample, double cosine) {
                Vec3d response = cosine * diffuse;
                const double toward_light = dot(reflected, sample.direction);
                if (has_highlights && toward_light > 0.0) {
                    const double highlight = std::pow(toward_light, material.shininess);
                    response = response + highlight * to_double(material.specular);
                }
                light = light + (1.0 / std::numbers::pi) * product(response, sample.irradiance);
            });
        return light;
    }

    int max_depth_;
};

}  // namespace

std::unique_ptr<Integrator> make_whitted(const IntegratorOptions& options) {
    return std::make_unique<Whitted>(options.max_depth);
}

}  // namespace coppice::render
