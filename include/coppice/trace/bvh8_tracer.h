#pragma once

#include "coppice/base/cpu.h"
#include "coppice/export.h"
#include "coppice/geom/ray.h"
#include "coppice/trace/traversal_counts.h"
#include "coppice/tree/bvh8.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace coppice::inline v0 {

struct TraceKernels;

/// Traces rays against an 8-wide tree, with the kernels of one instruction set. Hits equal those of
/// brute_force_intersect() to the bit, the lowest id of equally close ones included. Queries are
/// reentrant and allocate nothing; those of single rays never throw. A ray that is not traceable
/// hits nothing.
class COPPICE_EXPORT Bvh8Tracer {
public:
    /// Keeps the tree's arrays alive. Throws Error(invalid_argument) like choose_isa().
    explicit Bvh8Tracer(Bvh8 tree);

    /// The same with the kernels of one of available_isas().
    Bvh8Tracer(Bvh8 tree, Isa isa);

    /// The closest hit, or nothing.
    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const noexcept;

    /// True if the ray hits any triangle; stops at the first found.
    [[nodiscard]] bool occluded(const Ray& ray) const noexcept;

    /// The same, and adds to `counts` what it took; a primitive is a lane of a tested block.
    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray,
                                               TraversalCounts& counts) const noexcept;
    /// True if the ray hits any triangle; adds to `counts` what it took.
    [[nodiscard]] bool occluded(const Ray& ray, TraversalCounts& counts) const noexcept;

    /// The first `hits.size()` hits in order of t, then of id, that come after `*after`, or from
    /// the first on without it. Returns how many they are; fewer than asked for means that there
    /// are no more.
    std::size_t intersect_all(const Ray& ray, std::span<Hit> hits,
                              const Hit* after = nullptr) const noexcept;

    /// The number of triangles that the ray hits.
    [[nodiscard]] std::size_t count_hits(const Ray& ray) const noexcept;

    // The same for many rays, on at most `threads` threads (0 = all). They throw
    // Error(invalid_argument) for spans that do not fit together and for negative `threads`.

    /// The closest hit of each ray; one that is not is_hit() where there is none. Of each eight
    /// that follow one another, rays that go much the same way are traced 1.2 to 1.7 times as fast
    /// as alone: hand over rays of an image by rows or tiles.
    void intersect(std::span<const Ray> rays, std::span<Hit> hits, int threads = 0) const;

    /// 1 for each ray that hits anything, else 0.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> is_occluded,
                  int threads = 0) const;

    /// The first k hits of each ray in order, k = hits.size() / rays.size(): those of ray i are
    /// hits[i * k] and the following, counts[i] of them.
    void intersect_all(std::span<const Ray> rays, std::span<Hit> hits,
                       std::span<std::size_t> counts, int threads = 0) const;

    /// The number of triangles that each ray hits.
    void count_hits(std::span<const Ray> rays, std::span<std::size_t> counts,
                    int threads = 0) const;

    /// The tree that is traced.
    [[nodiscard]] const Bvh8& tree() const noexcept { return tree_; }

private:
    Bvh8 tree_;
    const TraceKernels* kernels_;
};

}  // namespace coppice::inline v0
