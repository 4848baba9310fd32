#include "render/encode_image.h"

#include "coppice/base/error.h"

#include <fmt/format.h>
#include <png.h>
#include <tinyexr.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

namespace coppice::render {

std::optional<ImageFormat> format_of(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".png") return ImageFormat::png;
    if (extension == ".exr") return ImageFormat::exr;
    if (extension == ".pfm") return ImageFormat::pfm;
    return std::nullopt;
}

std::string encode_png(const ScreenImage& image) {
    png_image description{};
    description.version = PNG_IMAGE_VERSION;
    description.width = static_cast<png_uint_32>(image.width);
    description.height = static_cast<png_uint_32>(image.height);
    description.format = PNG_FORMAT_RGB;
    static_assert(sizeof(Vec3<std::uint8_t>) == 3);
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(description);
    std::string file(size, '\0');
    const int is_written = png_image_write_to_memory(&description, file.data(), &size, 0,
                                                     image.pixels.data(), 0, nullptr);
    if (is_written == 0) {
        throw Error(ErrorCode::limit, fmt::format("cannot make a PNG of {} x {} pixels: {}",
                                                  image.width, image.height, description.message));
    }
    file.resize(size);
    return file;
}

std::string encode_exr(const Image& image) {
    constexpr std::size_t channel_count = 3;
    // Readers expect the channels in the order of their names: B, G, R.
    std::array<std::vector<float>, channel_count> planes;
    for (const Vec3f pixel : image.pixels) {
        planes[0].push_back(pixel.z);
        planes[1].push_back(pixel.y);
        planes[2].push_back(pixel.x);
    }
    std::array<unsigned char*, channel_count> plane_pointers{};
    std::array<EXRChannelInfo, channel_count> channels{};
    std::array<int, channel_count> pixel_types{};
    pixel_types.fill(TINYEXR_PIXELTYPE_FLOAT);
    for (std::size_t i = 0; i < channel_count; ++i) {
        plane_pointers[i] = reinterpret_cast<unsigned char*>(planes[i].data());
        channels[i].name[0] = std::string_view("BGR")[i];
    }

    EXRImage content;
    InitEXRImage(&content);
    content.images = plane_pointers.data();
    content.width = image.width;
    content.height = image.height;
    content.num_channels = channel_count;
    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = channel_count;
    header.channels = channels.data();
    header.pixel_types = pixel_types.data();
    header.requested_pixel_types = pixel_types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;

    unsigned char* bytes = nullptr;
    const char* problem = nullptr;
    const std::size_t size = SaveEXRImageToMemory(&content, &header, &bytes, &problem);
    const std::unique_ptr<unsigned char, decltype(&std::free)> owned(bytes, &std::free);
    if (size == 0) {
        const std::string reason = problem == nullptr ? "unknown reason" : problem;
        if (problem != nullptr) FreeEXRErrorMessage(problem);
        throw Error(ErrorCode::limit, fmt::format("cannot make an EXR of {} x {} pixels: {}",
                                                  image.width, image.height, reason));
    }
    return {reinterpret_cast<const char*>(bytes), size};
}

std::string encode_pfm(const Image& image) {
    static_assert(std::endian::native == std::endian::little);
    static_assert(sizeof(Vec3f) == 3 * sizeof(float));
    std::string file = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
    const auto row_length = static_cast<std::size_t>(image.width);
    file.reserve(file.size() + image.pixels.size() * sizeof(Vec3f));
    for (int y = image.height - 1; y >= 0; --y) {
        const std::span row(&image.at(0, y), row_length);
        file.append(reinterpret_cast<const char*>(row.data()), row.size_bytes());
    }
    return file;
}

}  // namespace coppice::render
