#pragma once

#include "coppice/base/cpu.h"
#include "coppice/geom/ray.h"
#include "coppice/trace/traversal_counts.h"
#include "coppice/tree/bvh8.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace coppice::inline v0 {

/// The traversals of an 8-wide tree for one instruction set. Rays that are not traceable hit
/// nothing.
struct TraceKernels {
    /// Finds the closest hit. Returns false if there is none.
    bool (*closest)(const Bvh8&, const Ray&, Hit&) noexcept;
    bool (*any)(const Bvh8&, const Ray&) noexcept;
    /// Batched queries for as many rays as there are results; 1 for a hit, else 0. Rays that are
    /// nearly parallel are traced as packets.
    void (*closest_of_each)(const Bvh8&, std::span<const Ray>, std::span<Hit>) noexcept;
    void (*any_of_each)(const Bvh8&, std::span<const Ray>, std::span<std::uint8_t>) noexcept;
    /// Writes the first hits after a given one, or from the start if it is null, in order into the
    /// span. Returns their number.
    std::size_t (*first)(const Bvh8&, const Ray&, std::span<Hit>, const Hit* after) noexcept;
    bool (*closest_counting)(const Bvh8&, const Ray&, Hit&, TraversalCounts&) noexcept;
    bool (*any_counting)(const Bvh8&, const Ray&, TraversalCounts&) noexcept;
};

/// True if a traceable ray hits one triangle of a block at a t of at most t_max; then sets the hit.
/// Computes as TriangleTest does.
[[nodiscard]] bool decide_alone(const TriangleBlock& block, std::size_t lane, const Ray& ray,
                                float t_max, Hit& hit) noexcept;

/// The traversals for an instruction set, which this processor must support.
[[nodiscard]] const TraceKernels& trace_kernels_for(Isa isa) noexcept;

}  // namespace coppice::inline v0
