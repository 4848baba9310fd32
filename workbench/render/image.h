#pragma once

#include "coppice/geom/vec3.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coppice::render {

/// Pixels of three numbers each, row by row from the upper left one.
template <typename Number>
struct PixelGrid {
    int width = 0;
    int height = 0;
    std::vector<Vec3<Number>> pixels;  ///< width * height

    PixelGrid() = default;

    /// All black.
    PixelGrid(int columns, int rows)
        : width(columns),
          height(rows),
          pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

    /// Pixel of column x and row y, both within the image.
    [[nodiscard]] Vec3<Number>& at(int x, int y) noexcept { return pixels[index(x, y)]; }

    [[nodiscard]] const Vec3<Number>& at(int x, int y) const noexcept {
        return pixels[index(x, y)];
    }

private:
    [[nodiscard]] std::size_t index(int x, int y) const noexcept {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

/// What an integrator measured: linear light, or numbers of another kind.
using Image = PixelGrid<float>;

/// What a screen shows: sRGB, 8 bits a channel.
using ScreenImage = PixelGrid<std::uint8_t>;

}  // namespace coppice::render
