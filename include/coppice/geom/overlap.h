#pragma once

#include "coppice/export.h"
#include "coppice/geom/aabb.h"
#include "coppice/geom/triangle.h"

namespace coppice::inline v0 {

/// True if a triangle and a closed box have a point in common, to within double precision: they
/// also count as overlapping if the gap between them is less than 2^-48 of their distances and
/// sizes. An empty box overlaps nothing. Boxes without extent and boxes with infinite bounds are
/// allowed. The corners of the triangle must be finite.
/// Source: [AkenineMoller2001].
[[nodiscard]] COPPICE_EXPORT bool overlaps(const Triangle& triangle, const Aabb& box) noexcept;

}  // namespace coppice::inline v0
