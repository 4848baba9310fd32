#include "render/integrator.h"

#include "coppice/base/named.h"

#include "render/integrators/integrators.h"

#include <nlohmann/json.hpp>

#include <array>

namespace coppice::render {

RayCounts& RayCounts::operator+=(const RayCounts& other) noexcept {
    primary += other.primary;
    shadow += other.shadow;
    reflection += other.reflection;
    occlusion += other.occlusion;
    diffuse += other.diffuse;
    steps += other.steps;
    return *this;
}

void to_json(nlohmann::json& json, const RayCounts& counts) {
    json = {{"primary", counts.primary},       {"shadow", counts.shadow},
            {"reflection", counts.reflection}, {"occlusion", counts.occlusion},
            {"diffuse", counts.diffuse},       {"total", counts.total()}};
}

std::span<const IntegratorEntry> integrator_registry() {
    static constexpr std::array entries{
        IntegratorEntry{"whitted", "lamps, shadows, highlights and mirrors, as Whitted's",
                        Display::light, make_whitted},
        IntegratorEntry{"ao", "ambient occlusion: how open each place is", Display::share,
                        make_ambient_occlusion},
        IntegratorEntry{"path", "path tracing: light over any number of diffuse surfaces",
                        Display::light, make_path},
        IntegratorEntry{"normal", "normals, as colours", Display::normal, make_normal},
        IntegratorEntry{"depth", "distance from the camera, near is bright", Display::depth,
                        make_depth},
        IntegratorEntry{"cost", "nodes visited and primitives tested by a ray, as a heat map",
                        Display::cost, make_cost},
    };
    return entries;
}

const IntegratorEntry& find_integrator(std::string_view name) {
    return find_named(integrator_registry(), name, "integrator");
}

}  // namespace coppice::render
