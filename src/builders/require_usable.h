#pragma once

#include "coppice/geom/primitive_set.h"

namespace coppice::inline v0 {

/// Throws what the set's require_valid() throws for its first invalid primitive, or else
/// Error(invalid_argument) naming the first primitive whose box is not finite. NaN would make
/// sorting and sweeping loop forever, and with an infinite box no plane pays.
void require_usable(PrimitiveSetView primitives);

}  // namespace coppice::inline v0
