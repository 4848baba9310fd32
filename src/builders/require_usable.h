#pragma once

#include "coppice/geom/primitive_set.h"

namespace coppice::inline v0 {

/// Throws what the set's require_valid() throws for its first invalid primitive, or else
/// Error(invalid_argument) naming the first primitive whose box is not finite: sorting and sweeping
/// would not end on NaN, and an infinite box leaves no plane that pays.
void require_usable(PrimitiveSetView primitives);

}  // namespace coppice::inline v0
