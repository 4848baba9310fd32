// A path tracer: at each hit the light of one point on every source (next event estimation), then
// one bounce, diffuse or mirrored by chance. An emitter may be found both ways, by its points and
// by a bounce; the balance heuristic weighs them, so that neither a near emitter nor a small one
// makes fireflies. The sky is found by bounces alone. From the fourth bounce on, paths that bring
// little are ended by chance (Russian roulette), which changes no expected value. Source:
// [Kajiya1986], [Veach1995] (balance heuristic), [Pharr2016] sec. 14.5.

#include "render/integrators/integrators.h"
#include "render/integrators/shading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coppice::render {

namespace {

constexpr int first_roulette = 3;

/// A path on its way.
struct Path {
    Ray ray;
    Vec3d share{1.0, 1.0, 1.0};  ///< of what the ray brings that reaches the camera
    double density = 0.0;  ///< of the ray's direction per solid angle; 0: the only one possible
};

class PathTracer : public Integrator {
public:
    explicit PathTracer(int max_depth) : max_depth_(max_depth) {}

    [[nodiscard]] Vec3d sample(const View& view, const Ray& ray, PixelSamples& random,
                               RayCounts& counts) const override {
        Path path{ray};
        ++counts.primary;
        Vec3d light;
        for (int depth = 0;; ++depth) {
            const Vec3d direction = to_double(path.ray.direction);
            const std::optional<Hit> hit = view.tracer->intersect(path.ray);
            if (!hit) return light + product(path.share, view.lighting->sky.radiance(direction));
            const Surface surface = surface_at(view.mesh, *view.attributes, path.ray, *hit);
            light = light + product(path.share, emitted(view, surface, path, *hit));
            const bool is_last = depth == max_depth_;
            const double bounce_share = is_last ? 0.0 : 1.0 - mirror_share(*surface.material);
            light = light + product(path.share,
                                    lit_by_sources(view, surface, bounce_share, random, counts));
            if (is_last || !bounce(surface, path, random, counts) ||
                (depth >= first_roulette && !survives(path, random))) {
                return light;
            }
        }
    }

private:
    /// What an emitter sends, less the share that sampled points on it account for.
    static Vec3d emitted(const View& view, const Surface& surface, const Path& path,
                         const Hit& hit) {
        const Vec3f emission = surface.material->emission;
        if (emission == Vec3f{} || path.density == 0.0) return to_double(emission);
        const double cosine = -dot(surface.facing, to_double(path.ray.direction));
        const double distance = hit.t;
        const double by_points = view.lighting->emitters.area_density(emission) * distance *
                                 distance / std::max(cosine, 1e-9);
        return path.density / (path.density + by_points) * to_double(emission);
    }

    /// The light of points on the sources, weighed against diffuse bounces, which are made with a
    /// probability of `bounce_share`.
    static Vec3d lit_by_sources(const View& view, const Surface& surface, double bounce_share,
                                PixelSamples& random, RayCounts& counts) {
        const Vec3d diffuse = to_double(surface.material->diffuse);
        Vec3d light;
        for_each_visible_light(
            view, surface, random, counts, [&](const LightSample& sample, double cosine) {
                const double by_bounce = bounce_share * cosine / std::numbers::pi;
                const double weight =
                    sample.density > 0.0 ? sample.density / (sample.density + by_bounce) : 1.0;
                light = light +
                        weight * cosine / std::numbers::pi * product(diffuse, sample.irradiance);
            });
        return light;
    }

    /// How often a bounce is a mirror's: by what mirror and diffuse colour have of the light.
    static double mirror_share(const Material& material) {
        if (!is_mirror(material)) return 0.0;
        const double mirror = largest(to_double(material.specular));
        return mirror / (mirror + largest(to_double(material.diffuse)));
    }

    /// Sends the path on; false if the surface is black.
    static bool bounce(const Surface& surface, Path& path, PixelSamples& random,
                       RayCounts& counts) {
        const Material& material = *surface.material;
        const double mirror = mirror_share(material);
        const double chosen = random.next_1d();
        if (chosen < mirror) {
            path.share = (1.0 / mirror) * product(path.share, to_double(material.specular));
            path.ray = mirror_ray(surface, to_double(path.ray.direction));
            path.density = 0.0;
            ++counts.reflection;
        } else {
            const Vec3d direction = cosine_weighted(surface, random);
            path.share = (1.0 / (1.0 - mirror)) * product(path.share, to_double(material.diffuse));
            path.ray = {surface.start(), to_float(direction)};
            path.density =
                (1.0 - mirror) * std::max(dot(direction, surface.normal), 0.0) / std::numbers::pi;
            ++counts.diffuse;
        }
        return largest(path.share) > 0.0;
    }

    static bool survives(Path& path, PixelSamples& random) {
        const double chance = std::clamp(std::sqrt(largest(path.share)), 0.05, 0.95);
        path.share = (1.0 / chance) * path.share;
        return random.next_1d() < chance;
    }

    int max_depth_;
};

}  // namespace

std::unique_ptr<Integrator> make_path(const IntegratorOptions& options) {
    return std::make_unique<PathTracer>(options.max_depth);
}

}  // namespace coppice::render
