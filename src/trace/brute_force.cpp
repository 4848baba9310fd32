// All ray queries by brute force. They share only the triangle test with the traversals.

#include "coppice/trace/brute_force.h"

#include "coppice/geom/triangle.h"

#include "trace/hit_list.h"

namespace coppice::inline v0 {
namespace {

// Calls `take(hit)` for every hit in order of id, until it returns true.
template <typename Take>
void for_each_hit(TriangleMeshView mesh, const Ray& ray, Take&& take) noexcept {
    if (!is_traceable(ray)) return;
    const TriangleTest test(ray);
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        auto hit = test(mesh.triangle(id), ray.t_max);
        if (!hit) continue;
        hit->prim = id;
        if (take(*hit)) return;
    }
}

}  // namespace

std::optional<Hit> brute_force_intersect(TriangleMeshView mesh, const Ray& ray) noexcept {
    std::optional<Hit> closest;
    for_each_hit(mesh, ray, [&](const Hit& hit) {
        if (!closest || hit.t < closest->t) closest = hit;
        return false;
    });
    return closest;
}

bool brute_force_occluded(TriangleMeshView mesh, const Ray& ray) noexcept {
    bool is_hit = false;
    for_each_hit(mesh, ray, [&](const Hit& /*hit*/) { return is_hit = true; });
    return is_hit;
}

std::size_t brute_force_intersect_all(TriangleMeshView mesh, const Ray& ray, std::span<Hit> hits,
                                      const Hit* after) noexcept {
    HitList list(hits, after);
    for_each_hit(mesh, ray, [&](const Hit& hit) {
        list.insert(hit);
        return false;
    });
    return list.size();
}

std::size_t brute_force_count_hits(TriangleMeshView mesh, const Ray& ray) noexcept {
    std::size_t count = 0;
    for_each_hit(mesh, ray, [&](const Hit& /*hit*/) {
        ++count;
        return false;
    });
    return count;
}

}  // namespace coppice::inline v0
