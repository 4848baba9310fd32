#include "render/develop.h"

#include "render/heat_map.h"
#include "scenes/vector_math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coppice::render {

namespace {

std::uint8_t byte_of(double share) {
    if (!(share > 0.0)) return 0;  // NaN, too
    return static_cast<std::uint8_t>(std::lround(255.0 * std::min(share, 1.0)));
}

using Pixel = Vec3<std::uint8_t>;

Pixel to_srgb(Vec3d light) {
    return {srgb_byte(light.x), srgb_byte(light.y), srgb_byte(light.z)};
}

Pixel show_light(Vec3d light, double factor) {
    const Vec3d exposed = factor * light;
    const double size = largest(exposed);
    if (!(size > 0.0)) return {};
    return to_srgb((compressed(size) / size) * exposed);
}

Pixel show_normal(Vec3d normal) {
    const auto channel = [](double x) { return byte_of(0.5 * x + 0.5); };
    return {channel(normal.x), channel(normal.y), channel(normal.z)};
}

/// Distances in an image, of the pixels that have one.
struct DepthRange {
    float nearest = std::numeric_limits<float>::infinity();
    float furthest = 0.0F;
};

DepthRange range_of(const Image& image) {
    DepthRange range;
    for (const Vec3f pixel : image.pixels) {
        if (!(pixel.x > 0.0F)) continue;
        range.nearest = std::min(range.nearest, pixel.x);
        range.furthest = std::max(range.furthest, pixel.x);
    }
    return range;
}

Pixel show_depth(double depth, const DepthRange& range) {
    constexpr double darkest = 0.1;  // what is there is not black
    if (!(depth > 0.0)) return {};
    const double extent = double{range.furthest} - range.nearest;
    const double share = extent > 0.0 ? (depth - range.nearest) / extent : 0.0;
    const std::uint8_t grey = byte_of(1.0 - (1.0 - darkest) * share);
    return {grey, grey, grey};
}

}  // namespace

double compressed(double light) noexcept {
    constexpr double knee = 0.8;
    constexpr double rest = 1.0 - knee;
    return light <= knee ? light : 1.0 - rest * std::exp(-(light - knee) / rest);
}

std::uint8_t srgb_byte(double light) noexcept {
    // IEC 61966-2-1.
    const double encoded =
        light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
    return byte_of(encoded);
}

ScreenImage develop(const Image& image, Display display, const DevelopOptions& options) {
    if (display == Display::cost) {
        return heat_map(image, options.cost_scale, "nodes + primitives per ray");
    }
    ScreenImage shown(image.width, image.height);
    const double factor = std::exp2(options.exposure);
    const DepthRange range = display == Display::depth ? range_of(image) : DepthRange{};
    std::transform(image.pixels.begin(), image.pixels.end(), shown.pixels.begin(),
                   [&](Vec3f pixel) -> Pixel {
                       const Vec3d value = to_double(pixel);
                       switch (display) {
                           case Display::light:
                               return show_light(value, factor);
                           case Display::share:
                               return to_srgb(value);
                           case Display::normal:
                               return show_normal(value);
                           case Display::depth:
                               return show_depth(value.x, range);
                           case Display::cost:
                               break;
                       }
                       return {};
                   });
    return shown;
}

}  // namespace coppice::render
