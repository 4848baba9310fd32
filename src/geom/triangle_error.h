#pragma once

#include <cmath>

namespace coppice::inline v0 {

/// The extent of a triangle in the frame of a ray (TriangleTest): the greatest distance of any
/// corner across the ray (`width`) and along it (`depth`).
struct FrameExtent {
    double width;
    double depth;
};

/// An upper bound of the rounding error of a weight (edge function) in double precision. Corners of
/// the sheared triangle have an error of at most 2^-51 of their distance.
[[nodiscard]] inline double weight_error(FrameExtent extent) noexcept {
    return 0x1.0p-47 * extent.width * (extent.width + extent.depth);
}

/// True if the weighted average of the corners' z is precise enough to be rounded to a float.
/// `weight_sum` is the sum of the weights, `range` the extent of the triangle's z. An error e of
/// the corners changes the weights by about width * e. The average then moves by that share of the
/// sum of all weights, times `range`.
[[nodiscard]] inline bool is_precise(double mean_z, double weight_sum, double range,
                                     FrameExtent extent) noexcept {
    const double spread = range * (extent.width + extent.depth) * extent.width;
    return spread <= 0x1.0p20 * std::abs(weight_sum * mean_z) &&
           extent.depth <= 0x1.0p20 * std::abs(mean_z);
}

}  // namespace coppice::inline v0
