#include "builders/bvh8/make_prim_refs.h"

#include "coppice/base/parallel.h"

#include "builders/chunk_sizes.h"
#include "builders/require_usable.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace coppice::inline v0::bvh8 {
namespace {

// An inlined triangle_bounds().
Aabb bounds_of_corners(const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const auto lowest = [](float p, float q, float r) { return std::min(std::min(p, q), r); };
    const auto highest = [](float p, float q, float r) { return std::max(std::max(p, q), r); };
    return {{lowest(a.x, b.x, c.x), lowest(a.y, b.y, c.y), lowest(a.z, b.z, c.z)},
            {highest(a.x, b.x, c.x), highest(a.y, b.y, c.y), highest(a.z, b.z, c.z)}};
}

// Returns 0 if all nine coordinates are finite, else NaN.
float finite_or_nan(const Triangle& triangle) {
    const auto sum = [](const Vec3f& v) { return v.x * 0.0F + v.y * 0.0F + v.z * 0.0F; };
    return sum(triangle[0]) + sum(triangle[1]) + sum(triangle[2]);
}

}  // namespace

void make_prim_refs(TriangleMeshView mesh, std::span<PrimRef> prim_refs) {
    std::atomic<bool> are_usable = true;
    parallel_for_chunks(
        prim_refs.size(), primitives_per_task, [&](std::size_t begin, std::size_t end) {
            const auto last = static_cast<std::uint32_t>(end);
            if (mesh.first_invalid(static_cast<std::uint32_t>(begin), last) != last) {
                are_usable = false;
                return;
            }
            float test = 0.0F;
            for (std::size_t at = begin; at < end; ++at) {
                const auto id = static_cast<std::uint32_t>(at);
                const Triangle triangle = mesh.triangle(id);
                prim_refs[at] = make_prim_ref(bounds_of_corners(triangle), id);
                test += finite_or_nan(triangle);
            }
            if (std::isnan(test)) are_usable = false;
        });
    if (!are_usable) require_usable(mesh);  // throws for the first one
}

}  // namespace coppice::inline v0::bvh8
