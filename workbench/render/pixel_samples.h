#pragma once

#include <array>
#include <cstdint>

namespace coppice::render {

/// The random numbers of one sample of a pixel: one point of the unit square after the other, each
/// from a Sobol sequence of its own, so that the samples of a pixel are well spread in every pair.
/// They depend on (pixel, sample, seed) and on how many were asked for, on nothing else.
class PixelSamples {
public:
    PixelSamples(std::uint32_t pixel, std::uint32_t sample, std::uint64_t seed) noexcept;

    /// The next point, in [0, 1) x [0, 1).
    [[nodiscard]] std::array<double, 2> next_2d() noexcept;

    /// The next number, in [0, 1).
    [[nodiscard]] double next_1d() noexcept { return next_2d()[0]; }

private:
    std::uint32_t sample_;
    std::uint64_t stream_;         ///< of the pixel
    std::uint64_t dimension_ = 0;  ///< pairs asked for so far
};

}  // namespace coppice::render
