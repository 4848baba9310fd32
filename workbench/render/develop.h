#pragma once

#include "render/image.h"
#include "render/integrator.h"

namespace coppice::render {

/// What a screen shows of linear light at most 0.8 is the light itself; what is above approaches 1
/// (1 - 0.2 exp(-(x - 0.8) / 0.2)). Takes light >= 0.
[[nodiscard]] double compressed(double light) noexcept;

/// Linear light in [0, 1] in the sRGB curve, 8 bits.
[[nodiscard]] std::uint8_t srgb_byte(double light) noexcept;

/// How numbers become what a screen shows.
struct DevelopOptions {
    double exposure = 0.0;    ///< in stops (factors of 2), for Display::light
    double cost_scale = 1.0;  ///< the cost at the end of the heat map, > 0, for Display::cost
};

/// An integrator's image as a screen shows it. Light is scaled until the largest channel is its
/// compressed() value, so that highlights keep their hue.
[[nodiscard]] ScreenImage develop(const Image& image, Display display,
                                  const DevelopOptions& options = {});

}  // namespace coppice::render
