// Numbers as colours, with the key to them in the image itself: a bar and its scale.

#include "render/heat_map.h"

#include "render/bitmap_font.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace coppice::render {

namespace {

using Pixel = Vec3<std::uint8_t>;

constexpr int letter_width = 6;  // with the gap behind it
constexpr int letter_height = 7;

/// Where the parts of the legend are, in pixels at size 1.
struct LegendPlan {
    static constexpr int margin = 4;
    static constexpr int bar_height = 8;
    static constexpr int height =
        margin + letter_height + margin + bar_height + margin + letter_height + margin;
};

void fill(ScreenImage& image, int x, int y, int width, int height, Pixel color) {
    for (int row = std::max(y, 0); row < std::min(y + height, image.height); ++row) {
        for (int column = std::max(x, 0); column < std::min(x + width, image.width); ++column) {
            image.at(column, row) = color;
        }
    }
}

void draw_glyph(ScreenImage& image, int x, int y, const Glyph& glyph, int size) {
    constexpr unsigned glyph_width = letter_width - 1;
    for (const std::uint8_t row : glyph.rows) {
        for (unsigned column = 0; column < glyph_width; ++column) {
            if ((row >> (glyph_width - 1 - column) & 1U) == 0) continue;
            fill(image, x + static_cast<int>(column) * size, y, size, size, {255, 255, 255});
        }
        y += size;
    }
}

int text_width(std::string_view text, int size) {
    return static_cast<int>(text.size()) * letter_width * size;
}

void draw_legend(ScreenImage& image, double scale, std::string_view title) {
    constexpr int label_count = 5;
    constexpr int least_width = 160;
    constexpr int least_height = 60;
    if (image.width < least_width || image.height < least_height) return;
    // Letters grow with the image.
    const int size = std::max(1, std::min(image.width / 640, image.height / 360));
    const int margin = LegendPlan::margin * size;
    const int width = std::min(image.width, (least_width + 80) * size);
    const int height = LegendPlan::height * size;
    const int top = image.height - height;
    fill(image, 0, top, width, height, {});
    draw_text(image, margin, top + margin, title, size);
    const int bar_top = top + 2 * margin + letter_height * size;
    const int bar_width = width - 2 * margin;
    for (int x = 0; x < bar_width; ++x) {
        fill(image, margin + x, bar_top, 1, LegendPlan::bar_height * size,
             heat_color((x + 0.5) / bar_width));
    }
    for (int i = 0; i < label_count; ++i) {
        const double share = static_cast<double>(i) / (label_count - 1);
        const bool is_last = i == label_count - 1;
        const std::string label = fmt::format("{:.4g}{}", scale * share, is_last ? "+" : "");
        // Centred below its place on the bar; the outer two are aligned with its ends.
        const int room = bar_width - text_width(label, size);
        const int center = static_cast<int>(share * bar_width) - text_width(label, size) / 2;
        draw_text(image, margin + std::clamp(center, 0, std::max(room, 0)),
                  bar_top + LegendPlan::bar_height * size + margin, label, size);
    }
}

}  // namespace

Pixel heat_color(double share) noexcept {
    constexpr std::array<std::array<double, 3>, 10> steps{{{0, 0, 4},
                                                           {27, 12, 65},
                                                           {74, 12, 107},
                                                           {120, 28, 109},
                                                           {165, 44, 96},
                                                           {207, 68, 70},
                                                           {237, 105, 37},
                                                           {251, 155, 6},
                                                           {247, 209, 61},
                                                           {252, 255, 164}}};
    const double place = share > 0.0 ? std::min(share, 1.0) * (steps.size() - 1) : 0.0;
    const std::size_t below = std::min(static_cast<std::size_t>(place), steps.size() - 2);
    const double part = place - static_cast<double>(below);
    const auto channel = [&](std::size_t i) {
        return static_cast<std::uint8_t>(
            std::lround((1.0 - part) * steps[below][i] + part * steps[below + 1][i]));
    };
    return {channel(0), channel(1), channel(2)};
}

double fitting_scale(const Image& image) {
    if (image.pixels.empty()) return 1.0;
    std::vector<float> values;
    values.reserve(image.pixels.size());
    for (const Vec3f pixel : image.pixels) {
        values.push_back(pixel.z);
    }
    const auto above = static_cast<std::ptrdiff_t>(values.size() / 1000);
    const auto nth = values.end() - 1 - above;
    std::nth_element(values.begin(), nth, values.end());
    const double wanted = std::max(1.0, static_cast<double>(*nth));
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * power >= wanted) return step * power;
    }
    return 10.0 * power;
}

ScreenImage heat_map(const Image& image, double scale, std::string_view title) {
    ScreenImage shown(image.width, image.height);
    std::transform(image.pixels.begin(), image.pixels.end(), shown.pixels.begin(),
                   [scale](Vec3f pixel) { return heat_color(pixel.z / scale); });
    draw_legend(shown, scale, title);
    return shown;
}

void draw_text(ScreenImage& image, int x, int y, std::string_view text, int size) {
    for (const char letter : text) {
        const auto* glyph = std::find_if(bitmap_font.begin(), bitmap_font.end(),
                                         [&](const Glyph& each) { return each.letter == letter; });
        if (glyph != bitmap_font.end()) draw_glyph(image, x, y, *glyph, size);
        x += letter_width * size;
    }
}

}  // namespace coppice::render
