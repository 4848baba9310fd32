// The report's pictures. Heat maps of two trees share one scale, so that they can be compared: its
// end is what one pixel in a thousand of both exceeds. The difference has a scale of its own, white
// where nothing changes, and colours that colour-blind eyes can tell apart towards either end.

#include "exhibits/scene_picture.h"

#include "render/develop.h"
#include "render/encode_image.h"
#include "render/heat_map.h"
#include "render/render.h"
#include "statistics/mean.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace coppice::lab {

namespace {

using Color = Vec3<std::uint8_t>;

constexpr int picture_width = 960;
constexpr int heat_map_width = 640;

constexpr int height_of(int width) {
    return width * 9 / 16;
}

render::RenderOptions options_of(const PictureScene& scene, int width, int samples) {
    return {
        .width = width, .height = height_of(width), .samples = samples, .threads = scene.threads};
}

/// The steps of each pixel's rays in a tree.
render::Image count_steps(const PictureScene& scene, const KdTree& tree) {
    const TracedTree tracer(scene.mesh, tree);
    const render::Lighting dark{};
    const render::View view{&tracer, scene.mesh, scene.attributes, &dark};
    const auto integrator = render::find_integrator("cost").make({});
    return render::render(view, scene.camera, *integrator, options_of(scene, heat_map_width, 2))
        .image;
}

std::vector<float> steps_of(const render::Image& image) {
    std::vector<float> steps;
    steps.reserve(image.pixels.size());
    for (const Vec3f pixel : image.pixels) {
        steps.push_back(pixel.z);
    }
    return steps;
}

/// A round number that at most one value in a thousand exceeds; at least 1.
double scale_end(std::vector<float> values) {
    if (values.empty()) return 1.0;
    const auto above = static_cast<std::ptrdiff_t>(values.size() / 1000);
    const auto nth = values.end() - 1 - above;
    std::nth_element(values.begin(), nth, values.end());
    const double wanted = std::max(1.0, static_cast<double>(*nth));
    const double unit = std::pow(10.0, std::floor(std::log10(wanted)) - 1.0);
    return std::ceil(wanted / unit) * unit;
}

/// The colour of a change in [-1, 1]: blue, white, orange. The ends are of Okabe and Ito's palette,
/// darkened.
Color change_color(double change) {
    constexpr std::array<double, 3> less{0, 90, 160};
    constexpr std::array<double, 3> more{190, 75, 0};
    const double strength = std::min(std::abs(change), 1.0);
    const auto& end = change < 0.0 ? less : more;
    const auto channel = [&](std::size_t i) {
        return static_cast<std::uint8_t>(std::lround((1.0 - strength) * 255.0 + strength * end[i]));
    };
    return {channel(0), channel(1), channel(2)};
}

template <typename ColorOf>
report::ColorScale make_scale(double low, double high, ColorOf color_of) {
    constexpr int step_count = 16;
    report::ColorScale scale{{}, low, high};
    for (int i = 0; i <= step_count; ++i) {
        const Color color = color_of(low + (high - low) * i / step_count);
        scale.colors.push_back(fmt::format("#{:02x}{:02x}{:02x}", color.x, color.y, color.z));
    }
    return scale;
}

template <typename ColorOf>
report::Picture draw(const std::vector<float>& values, ColorOf color_of) {
    render::ScreenImage image(heat_map_width, height_of(heat_map_width));
    std::transform(values.begin(), values.end(), image.pixels.begin(),
                   [&](float value) { return color_of(double{value}); });
    return {render::encode_png(image), image.width, image.height};
}

}  // namespace

report::Picture render_picture(const PictureScene& scene, const TracedTree& tracer) {
    render::Lighting lighting{
        {}, {{}, scene.camera.up}, render::Emitters(scene.mesh, *scene.attributes)};
    if (lighting.emitters.is_empty()) {
        lighting.lamp = render::Lamp{
            .position = render::place_light(scene.camera, bounds_of(scene.mesh.vertices()))};
    }
    const render::View view{&tracer, scene.mesh, scene.attributes, &lighting};
    const render::IntegratorEntry& entry = render::find_integrator("whitted");
    const render::Image image =
        render::render(view, scene.camera, *entry.make({}), options_of(scene, picture_width, 4))
            .image;
    return {render::encode_png(render::develop(image, entry.display)), image.width, image.height};
}

report::HeatMaps render_heat_maps(const PictureScene& scene, const KdTree& full,
                                  const KdTree* other) {
    report::HeatMaps maps;
    const std::vector<float> full_steps = steps_of(count_steps(scene, full));
    const std::vector<float> other_steps =
        other != nullptr ? steps_of(count_steps(scene, *other)) : std::vector<float>{};
    std::vector<float> both = full_steps;
    both.insert(both.end(), other_steps.begin(), other_steps.end());
    const double end = scale_end(std::move(both));
    const auto steps_color = [end](double steps) { return render::heat_color(steps / end); };
    maps.steps = make_scale(0.0, end, steps_color);
    maps.full = draw(full_steps, steps_color);
    maps.full_mean = mean_of(full_steps);
    if (other == nullptr) return maps;

    maps.other = draw(other_steps, steps_color);
    maps.other_mean = mean_of(other_steps);
    std::vector<float> change(full_steps.size());
    std::transform(other_steps.begin(), other_steps.end(), full_steps.begin(), change.begin(),
                   std::minus<>());
    std::vector<float> size(change.size());
    std::transform(change.begin(), change.end(), size.begin(),
                   [](float value) { return std::abs(value); });
    const double most = scale_end(std::move(size));
    const auto color_of = [most](double value) { return change_color(value / most); };
    maps.change = make_scale(-most, most, color_of);
    maps.difference = draw(change, color_of);
    return maps;
}

}  // namespace coppice::lab
