#pragma once

#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/tree/bvh8.h"

#include <cstdint>
#include <optional>
#include <span>

namespace coppice::lab {

/// What a ray hits first in truth.
struct ExactHit {
    double t = 0.0;  ///< the exact distance, rounded once
    std::uint32_t prim = 0;
};

/// Says what rays hit, by exact arithmetic. For those few that tracers do not agree on: one takes
/// about as long as a thousand rays traced.
class ExactJudge {
public:
    /// The mesh must outlive the judge.
    explicit ExactJudge(TriangleMeshView mesh);

    /// The closest exact hit with a t that is in the ray's limits once it is rounded to float.
    /// Triangles that may be met are found with a tree of the judge's own; those `claimed` to be
    /// hit are looked at in any case, so that a hit that any tracer found is never overlooked.
    [[nodiscard]] std::optional<ExactHit> closest(const Ray& ray,
                                                  std::span<const std::uint32_t> claimed) const;

private:
    TriangleMeshView mesh_;
    Bvh8 tree_;
};

}  // namespace coppice::lab
