// What the camera sees without any light: normals and distances.

#include "render/integrators/integrators.h"
#include "render/surface.h"

namespace coppice::render {

namespace {

class NormalIntegrator : public Integrator {
public:
    [[nodiscard]] Vec3d sample(const View& view, const Ray& ray, PixelSamples& /*random*/,
                               RayCounts& counts) const override {
        ++counts.primary;
        const std::optional<Hit> hit = view.tracer->intersect(ray);
        return hit ? surface_at(view.mesh, *view.attributes, ray, *hit).normal : Vec3d{};
    }
};

class DepthIntegrator : public Integrator {
public:
    /// The distance, and 1 for a hit.
    [[nodiscard]] Vec3d sample(const View& view, const Ray& ray, PixelSamples& /*random*/,
                               RayCounts& counts) const override {
        ++counts.primary;
        const std::optional<Hit> hit = view.tracer->intersect(ray);
        return hit ? Vec3d{hit->t, 1.0, 0.0} : Vec3d{};
    }

    [[nodiscard]] Vec3d pixel_of(Vec3d sum, int /*sample_count*/) const noexcept override {
        const double distance = sum.y > 0.0 ? sum.x / sum.y : 0.0;
        return {distance, distance, distance};
    }
};

}  // namespace

std::unique_ptr<Integrator> make_normal(const IntegratorOptions& /*options*/) {
    return std::make_unique<NormalIntegrator>();
}

std::unique_ptr<Integrator> make_depth(const IntegratorOptions& /*options*/) {
    return std::make_unique<DepthIntegrator>();
}

}  // namespace coppice::render
