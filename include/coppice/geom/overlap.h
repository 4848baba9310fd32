#pragma once

#include "coppice/export.h"
#include "coppice/geom/aabb.h"
#include "coppice/geom/triangle.h"

namespace coppice::inline v0 {

/// True if a triangle and a closed box have a point in common, as far as double precision can tell:
/// where they touch, or miss each other by less than 2^-48 of their distances and sizes, they
/// overlap. An empty box overlaps nothing; one without extent or without end will do. The
/// triangle's corners must be finite.
/// Source: [AkenineMoller2001].
[[nodiscard]] COPPICE_EXPORT bool overlaps(const Triangle& triangle, const Aabb& box) noexcept;

}  // namespace coppice::inline v0
