#pragma once

#include "render/image.h"
#include "render/integrator.h"

namespace coppice::render {

/// What a screen shows of linear light at most 0.8 is the light itself; what is above approaches 1
/// (1 - 0.2 exp(-(x - 0.8) / 0.2)). Takes light >= 0.
[[nodiscard]] double compressed(double light) noexcept;

/// Linear light in [0, 1] in the sRGB curve, 8 bits.
[[nodiscard]] std::uint8_t srgb_byte(double light) noexcept;

/// An integrator's image as a screen shows it. `exposure` is in stops (factors of 2) and only for
/// Display::light, whose colours are scaled until the largest channel is its compressed() value, so
/// that highlights keep their hue.
[[nodiscard]] ScreenImage develop(const Image& image, Display display, double exposure);

}  // namespace coppice::render
