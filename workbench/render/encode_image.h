#pragma once

#include "render/image.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace coppice::render {

/// The kinds of image files that can be written.
enum class ImageFormat { png, exr, pfm };

/// The format that a file's name ends in, upper or lower case; nothing for any other ending.
[[nodiscard]] std::optional<ImageFormat> format_of(const std::filesystem::path& file);

/// A PNG file of 8 bits a channel. Throws Error(limit) if libpng refuses.
[[nodiscard]] std::string encode_png(const ScreenImage& image);

/// An OpenEXR file of 32-bit floats, deflated. Throws Error(limit) if tinyexr refuses.
[[nodiscard]] std::string encode_exr(const Image& image);

/// A portable float map: 32-bit floats, little-endian, the lowest row first.
[[nodiscard]] std::string encode_pfm(const Image& image);

}  // namespace coppice::render
