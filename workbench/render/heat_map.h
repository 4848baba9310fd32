#pragma once

#include "render/image.h"

#include <string_view>

namespace coppice::render {

/// The colour of a share in [0, 1], from black over purple and orange to a light yellow: equal
/// steps look equal, also to colour-blind eyes and in grey. What is outside is taken for 0 or 1.
/// Source: [Inferno2015].
[[nodiscard]] Vec3<std::uint8_t> heat_color(double share) noexcept;

/// A scale that fits an image's brightest channel z: 1, 2 or 5 times a power of ten that at most
/// one pixel in a thousand exceeds; at least 1.
[[nodiscard]] double fitting_scale(const Image& image);

/// Channel z of an image as colours, `scale` and more as the last one, with a legend in the lower
/// left corner if the image has room for it: at least 160 x 60 pixels.
[[nodiscard]] ScreenImage heat_map(const Image& image, double scale, std::string_view title);

/// Writes white text, letters of 5 x 7 pixels with one between, all `size` times as large, its
/// upper left corner at (x, y). What is outside the image is cut off. Knows digits, small letters,
/// `.+-`.
void draw_text(ScreenImage& image, int x, int y, std::string_view text, int size);

}  // namespace coppice::render
