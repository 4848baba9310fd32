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

/// Traces rays against an 8-wide tree with the kernels of one instruction set. Hits equal those of
/// brute_force_intersect() to the bit; of equally close hits the lowest id wins. Queries are
/// reentrant and allocate nothing. Queries of single rays never throw. A ray that is not traceable
/// (is_traceable()) hits nothing.
class COPPICE_EXPORT Bvh8Tracer {
public:
    /// Prepares a tree for tracing and keeps its arrays alive. Throws Error(invalid_argument) if
    /// COPPICE_ISA is invalid; see choose_isa().
    explicit Bvh8Tracer(Bvh8 tree);

    /// Prepares a tree for the kernels of `isa`, which must be one of available_isas().
    Bvh8Tracer(Bvh8 tree, Isa isa);

    /// The closest hit, or nothing.
    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const noexcept;

    /// True if the ray hits any triangle. Stops at the first hit found.
    [[nodiscard]] bool occluded(const Ray& ray) const noexcept;

    /// The closest hit, or nothing. Adds the work of the traversal to `counts`; each lane of a
    /// tested block counts as a primitive.
    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray,
                                               TraversalCounts& counts) const noexcept;
    /// True if the ray hits any triangle. Adds the work of the traversal to `counts`.
    [[nodiscard]] bool occluded(const Ray& ray, TraversalCounts& counts) const noexcept;

    /// Writes the first hits in order of t, then of id, to the front of `hits`, at most hits.size()
    /// of them. Only hits after `*after` in that order count; null means all. Returns the number
    /// written; fewer than hits.size() means that no more follow.
    std::size_t intersect_all(const Ray& ray, std::span<Hit> hits,
                              const Hit* after = nullptr) const noexcept;

    /// The number of triangles that the ray hits.
    [[nodiscard]] std::size_t count_hits(const Ray& ray) const noexcept;

    // Batched queries, on at most `threads` threads (0 = all hardware threads). They throw
    // Error(invalid_argument) if the lengths of the spans do not fit or `threads` is negative.

    /// Writes the closest hit of rays[i] to hits[i]; without a hit, hits[i].is_hit() is false.
    /// Every eight consecutive rays that are nearly parallel are traced as a packet, 1.2 to 1.7
    /// times as fast as single rays: pass the rays of an image in rows or tiles.
    void intersect(std::span<const Ray> rays, std::span<Hit> hits, int threads = 0) const;

    /// Sets is_occluded[i] to 1 if rays[i] hits any triangle, otherwise to 0.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> is_occluded,
                  int threads = 0) const;

    /// The first k hits of each ray in order, k = hits.size() / rays.size(). Writes the hits of
    /// rays[i] to hits[i * k] and the following, and their number to counts[i].
    void intersect_all(std::span<const Ray> rays, std::span<Hit> hits,
                       std::span<std::size_t> counts, int threads = 0) const;

    /// Writes the number of triangles that rays[i] hits to counts[i].
    void count_hits(std::span<const Ray> rays, std::span<std::size_t> counts,
                    int threads = 0) const;

    /// The tree that rays are traced against.
    [[nodiscard]] const Bvh8& tree() const noexcept { return tree_; }

private:
    Bvh8 tree_;
    const TraceKernels* kernels_;
};

}  // namespace coppice::inline v0
