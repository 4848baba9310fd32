#pragma once

#include <cmath>

namespace coppice::inline v0 {

/// Of a triangle in the frame of a ray (TriangleTest): the most of any corner across and along it.
struct FrameExtent {
    double width;
    double depth;
};

/// More than rounding does to a weight (edge function) in double precision: the corners of the
/// sheared triangle are off by 2^-51 of their distance.
[[nodiscard]] inline double weight_error(FrameExtent extent) noexcept {
    return 0x1.0p-47 * extent.width * (extent.width + extent.depth);
}

/// Whether the average of the corners' z by weights, whose sum this is, has enough digits left for
/// a float. As far as the corners are off, weights are by width times as much, and the average by
/// what this is of all weights, from one end of the triangle's z to the other (`range`).
[[nodiscard]] inline bool is_precise(double mean_z, double weight_sum, double range,
                                     FrameExtent extent) noexcept {
    const double spread = range * (extent.width + extent.depth) * extent.width;
    return spread <= 0x1.0p20 * std::abs(weight_sum * mean_z) &&
           extent.depth <= 0x1.0p20 * std::abs(mean_z);
}

}  // namespace coppice::inline v0
