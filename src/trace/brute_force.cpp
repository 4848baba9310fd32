#include "coppice/trace/brute_force.h"

namespace coppice {

std::optional<Hit> brute_force_intersect(TriangleMeshView mesh, const Ray& ray) noexcept {
    std::optional<Hit> closest;
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        auto hit = intersect_triangle(ray, mesh.triangle(id));
        if (hit && (!closest || hit->t < closest->t)) {
            hit->prim = id;
            closest = hit;
        }
    }
    return closest;
}

bool brute_force_occluded(TriangleMeshView mesh, const Ray& ray) noexcept {
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        if (intersect_triangle(ray, mesh.triangle(id))) return true;
    }
    return false;
}

}  // namespace coppice
