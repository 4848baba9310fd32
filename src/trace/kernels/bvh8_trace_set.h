// The traversals of the 8-wide tree on the lanes of one instruction set. Hits equal those of brute
// force on every set.

#include "simd/set.h"

#if defined(COPPICE_TRACE_KERNELS_BVH8_TRACE_SET_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_TRACE_KERNELS_BVH8_TRACE_SET_H
#else
#define COPPICE_TRACE_KERNELS_BVH8_TRACE_SET_H
#endif

#include "coppice/geom/ray.h"
#include "coppice/tree/bvh8.h"

#include "trace/kernels/bvh8_queries.h"
#include "trace/kernels/bvh8_trace.h"
#include "trace/kernels/bvh8_traversal.h"
#include "trace/kernels/packet_traversal.h"

#include <cstddef>
#include <span>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

template <typename Counter>
bool find_closest(const Bvh8& tree, const Ray& ray, Hit& hit, Counter counter) noexcept {
    const ShearedRay sheared(ray);
    ClosestHitQuery query(ray, sheared);
    search(tree, ray, sheared, query, counter);
    return query.finish(hit);
}

template <typename Counter>
bool find_any(const Bvh8& tree, const Ray& ray, Counter counter) noexcept {
    const ShearedRay sheared(ray);
    AnyHitQuery query(ray, sheared);
    search(tree, ray, sheared, query, counter);
    return query.is_hit();
}

constexpr TraceKernels kernels{
    .closest = [](const Bvh8& tree, const Ray& ray,
                  Hit& hit) noexcept { return find_closest(tree, ray, hit, NoCounts{}); },
    .any = [](const Bvh8& tree,
              const Ray& ray) noexcept { return find_any(tree, ray, NoCounts{}); },
    .closest_of_each =
        [](const Bvh8& tree, std::span<const Ray> rays, std::span<Hit> hits) noexcept {
            trace_in_packets<ClosestHitQuery>(
                tree, rays,
                [&](std::size_t i, ClosestHitQuery& query) {
                    if (!query.finish(hits[i])) hits[i] = Hit{};
                },
                [&](std::size_t i) {
                    if (!find_closest(tree, rays[i], hits[i], NoCounts{})) hits[i] = Hit{};
                });
        },
    .any_of_each =
        [](const Bvh8& tree, std::span<const Ray> rays,
           std::span<std::uint8_t> is_occluded) noexcept {
            trace_in_packets<AnyHitQuery>(
                tree, rays,
                [&](std::size_t i, const AnyHitQuery& query) {
                    is_occluded[i] = query.is_hit() ? 1 : 0;
                },
                [&](std::size_t i) {
                    is_occluded[i] = find_any(tree, rays[i], NoCounts{}) ? 1 : 0;
                });
        },
    .first = [](const Bvh8& tree, const Ray& ray, std::span<Hit> hits,
                const Hit* after) noexcept -> std::size_t {
        if (hits.empty()) return 0;
        const ShearedRay sheared(ray);
        FirstKHitsQuery query(ray, sheared, hits, after);
        search(tree, ray, sheared, query, NoCounts{});
        return query.count();
    },
    .closest_counting =
        [](const Bvh8& tree, const Ray& ray, Hit& hit, TraversalCounts& counts) noexcept {
            return find_closest(tree, ray, hit, Counts{counts});
        },
    .any_counting =
        [](const Bvh8& tree, const Ray& ray, TraversalCounts& counts) noexcept {
            return find_any(tree, ray, Counts{counts});
        },
};

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

COPPICE_SIMD_END

#endif
