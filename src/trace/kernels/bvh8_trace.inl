// Traversal of the 8-wide tree: included once for each instruction set, in a namespace of its own,
// after that set's lanes_*.inl and a decide_*.inl. Hits are those of brute force on every set.

// Each of these builds on those before.
// clang-format off
#include "trace/kernels/bvh8_boxes.inl"
#include "trace/kernels/bvh8_triangles.inl"
#include "trace/kernels/bvh8_queries.inl"
#include "trace/kernels/bvh8_traversal.inl"
#include "trace/kernels/ray_packet.inl"
#include "trace/kernels/packet_traversal.inl"

// clang-format on

template <typename Counter>
bool find_closest(const Bvh8& tree, const Ray& ray, Hit& hit, Counter counter) noexcept {
    const ShearedRay sheared(ray);
    ClosestHit query(ray, sheared);
    search(tree, ray, sheared, query, counter);
    return query.finish(hit);
}

template <typename Counter>
bool find_any(const Bvh8& tree, const Ray& ray, Counter counter) noexcept {
    const ShearedRay sheared(ray);
    AnyHit query(ray, sheared);
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
            trace_in_groups<ClosestHit>(
                tree, rays,
                [&](std::size_t i, ClosestHit& query) {
                    if (!query.finish(hits[i])) hits[i] = Hit{};
                },
                [&](std::size_t i) {
                    if (!find_closest(tree, rays[i], hits[i], NoCounts{})) hits[i] = Hit{};
                });
        },
    .any_of_each =
        [](const Bvh8& tree, std::span<const Ray> rays,
           std::span<std::uint8_t> is_occluded) noexcept {
            trace_in_groups<AnyHit>(
                tree, rays,
                [&](std::size_t i, const AnyHit& query) {
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
        FirstHits query(ray, sheared, hits, after);
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
