// Ambient occlusion: one ray a sample from the surface into a random direction, distributed as the
// cosine; the share of those that meet nothing within a distance.
// Source: [Pharr2016] sec. 13.6.3 (cosine-weighted directions).

#include "render/integrators/integrators.h"
#include "render/integrators/shading.h"

namespace coppice::render {

namespace {

class AmbientOcclusion : public Integrator {
public:
    explicit AmbientOcclusion(double distance) : distance_(static_cast<float>(distance)) {}

    [[nodiscard]] Vec3d sample(const View& view, const Ray& ray, PixelSamples& random,
                               RayCounts& counts) const override {
        constexpr Vec3d open{1.0, 1.0, 1.0};
        ++counts.primary;
        const std::optional<Hit> hit = view.tracer->intersect(ray);
        if (!hit) return open;
        const Surface surface = surface_at(view.mesh, *view.attributes, ray, *hit);
        const Vec3f direction = to_float(cosine_weighted(surface, random));
        ++counts.occlusion;
        return view.tracer->occluded({surface.start(), direction, 0.0F, distance_}) ? Vec3d{}
                                                                                    : open;
    }

private:
    float distance_;
};

}  // namespace

std::unique_ptr<Integrator> make_ambient_occlusion(const IntegratorOptions& options) {
    return std::make_unique<AmbientOcclusion>(options.ao_distance);
}

}  // namespace coppice::render
