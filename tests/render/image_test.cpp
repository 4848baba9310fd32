// Images as files and on the screen, and the samples that they are made of.
#include "render/image.h"

#include "render/develop.h"
#include "render/encode_image.h"
#include "render/heat_map.h"
#include "render/pixel_samples.h"

#include <gtest/gtest.h>
#include <png.h>
#include <tinyexr.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <set>

namespace coppice::render {

namespace {

Image gradient() {
    Image image(3, 2);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 3; ++x) {
            image.at(x, y) = {static_cast<float>(x), static_cast<float>(y), -1e9F};
        }
    }
    return image;
}

TEST(EncodeImage, ChoosesByTheEndOfTheName) {
    EXPECT_EQ(format_of("a/b.PNG"), ImageFormat::png);
    EXPECT_EQ(format_of("b.exr"), ImageFormat::exr);
    EXPECT_EQ(format_of("b.png.pfm"), ImageFormat::pfm);
    EXPECT_EQ(format_of("png"), std::nullopt);
    EXPECT_EQ(format_of(".png"), std::nullopt);
}

TEST(EncodeImage, PngReadsBackAsItWas) {
    ScreenImage image(2, 2);
    image.pixels = {{1, 2, 3}, {4, 5, 6}, {255, 0, 0}, {9, 9, 9}};
    const std::string file = encode_png(image);
    png_image read{};
    read.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_memory(&read, file.data(), file.size()), 0);
    EXPECT_EQ(read.width, 2U);
    read.format = PNG_FORMAT_RGB;
    std::array<std::uint8_t, 12> bytes{};
    ASSERT_NE(png_image_finish_read(&read, nullptr, bytes.data(), 0, nullptr), 0);
    EXPECT_EQ(std::memcmp(bytes.data(), image.pixels.data(), bytes.size()), 0);
}

TEST(EncodeImage, ExrReadsBackAsItWas) {
    const std::string file = encode_exr(gradient());
    float* read = nullptr;
    int width = 0;
    int height = 0;
    const char* problem = nullptr;
    ASSERT_EQ(LoadEXRFromMemory(&read, &width, &height,
                                reinterpret_cast<const unsigned char*>(file.data()), file.size(),
                                &problem),
              TINYEXR_SUCCESS);
    const std::unique_ptr<float, decltype(&std::free)> owned(read, &std::free);
    EXPECT_EQ(width, 3);
    EXPECT_EQ(height, 2);
    EXPECT_EQ(read[4 * 5 + 0], 2.0F);
    EXPECT_EQ(read[4 * 5 + 1], 1.0F);
    EXPECT_EQ(read[4 * 5 + 2], -1e9F);
}

TEST(EncodeImage, PfmHasTheLowestRowFirst) {
    const std::string file = encode_pfm(gradient());
    const std::string head = "PF\n3 2\n-1.0\n";
    ASSERT_TRUE(file.starts_with(head));
    ASSERT_EQ(file.size(), head.size() + sizeof(float) * 3 * 2 * 3);
    std::array<float, 6> first{};
    std::memcpy(first.data(), file.data() + head.size(), sizeof first);
    EXPECT_EQ(first, (std::array{0.0F, 1.0F, -1e9F, 1.0F, 1.0F, -1e9F}));
}

TEST(Develop, FollowsTheCurves) {
    EXPECT_EQ(srgb_byte(0.0), 0);
    EXPECT_EQ(srgb_byte(0.2159), 128);
    EXPECT_EQ(srgb_byte(1.0), 255);
    EXPECT_EQ(srgb_byte(std::numeric_limits<double>::quiet_NaN()), 0);
    EXPECT_EQ(compressed(0.8), 0.8);
    EXPECT_NEAR(compressed(0.801), 0.801, 1e-5);
    EXPECT_LT(compressed(5.0), 1.0);
    Image image(2, 1);
    image.pixels = {{0.2F, 0.1F, 0.0F}, {4.0F, 2.0F, 0.0F}};
    const ScreenImage lit = develop(image, Display::light, {.exposure = 1.0});
    EXPECT_EQ(lit.pixels[0].x, srgb_byte(0.4));
    EXPECT_EQ(lit.pixels[1].y, srgb_byte(0.5 * compressed(8.0)));  // the hue stays
    image.pixels = {{-1.0F, 0.0F, 1.0F}, {}};
    EXPECT_EQ(develop(image, Display::normal).pixels[0], (Vec3<std::uint8_t>{0, 128, 255}));
    image.pixels = {{2.0F, 2.0F, 2.0F}, {}};
    const ScreenImage depth = develop(image, Display::depth);
    EXPECT_EQ(depth.pixels[0].x, 255);
    EXPECT_EQ(depth.pixels[1].x, 0);
}

TEST(HeatMap, GrowsBrighterAndHasALegend) {
    int before = -1;
    for (int i = 0; i <= 100; ++i) {
        const auto color = heat_color(0.01 * i);
        const int brightness = 2 * color.x + 7 * color.y + color.z;
        EXPECT_GE(brightness, before - 1);
        before = brightness;
    }
    EXPECT_EQ(heat_color(-1.0), heat_color(0.0));
    EXPECT_EQ(heat_color(7.0), heat_color(1.0));
    Image image(200, 100);
    for (Vec3f& pixel : image.pixels) {
        pixel.z = 30.0F;
    }
    image.pixels[7].z = 1e6F;  // one pixel does not set the scale
    EXPECT_EQ(fitting_scale(image), 50.0);
    EXPECT_EQ(fitting_scale(Image(5, 5)), 1.0);
    const ScreenImage shown = heat_map(image, 60.0, "nodes");
    EXPECT_EQ(shown.at(100, 10), heat_color(0.5));
    EXPECT_EQ(shown.at(7, 0), heat_color(1.0));
    EXPECT_EQ(shown.at(0, 99), (Vec3<std::uint8_t>{0, 0, 0}));
    EXPECT_EQ(std::count(shown.pixels.begin(), shown.pixels.end(),
                         Vec3<std::uint8_t>{255, 255, 255}) > 50,
              true);
    const Image small(100, 50);
    EXPECT_EQ(heat_map(small, 1.0, "nodes").at(0, 49), heat_color(0.0));
}

TEST(PixelSamples, AreStratifiedInEveryPair) {
    constexpr std::uint32_t count = 64;
    for (int pair = 0; pair < 5; ++pair) {
        std::set<int> rows;
        std::set<int> columns;
        std::set<int> cells;
        for (std::uint32_t sample = 0; sample < count; ++sample) {
            PixelSamples random(17, sample, 5);
            for (int i = 0; i < pair; ++i) {
                static_cast<void>(random.next_2d());
            }
            const auto [x, y] = random.next_2d();
            rows.insert(static_cast<int>(x * count));
            columns.insert(static_cast<int>(y * count));
            cells.insert(static_cast<int>(x * 8) * 8 + static_cast<int>(y * 8));
        }
        EXPECT_EQ(rows.size(), count);
        EXPECT_EQ(columns.size(), count);
        EXPECT_EQ(cells.size(), count);
    }
}

}  // namespace

}  // namespace coppice::render
