#include "render_arguments.h"

#include "command.h"
#include "options.h"
#include "render/encode_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace coppice::app {

namespace {

constexpr double infinity = std::numeric_limits<double>::max();

}  // namespace

void add_image(CLI::App& parser, RenderRequest& request) {
    add_text(parser, {"-o,--out", "FILE", "The image to write: .png, .exr or .pfm", ""},
             request.out);
    add_name(parser,
             {"--integrator", "NAME",
              listing("What is shown", names_in(render::integrator_registry())), "whitted"},
             request.integrator, names_in(render::integrator_registry()));
    const auto read_size = [&options = request.options](const std::string& given) {
        const PixelSize size = parse_size("--size", given, render::RenderOptions::max_size);
        options.width = size.width;
        options.height = size.height;
    };
    parser.add_option_function<std::string>("--size", read_size, "Pixels of the image")
        ->type_name("WxH")
        ->default_str("1280x720");
    add_whole(parser, {"--spp", "N", "Samples per pixel", "16"}, request.options.samples, 1,
              render::RenderOptions::max_samples);
    add_number(parser, {"--exposure", "STOPS", "Brighter by so many factors of 2 (.png)", "0"},
               request.develop.exposure, {-100.0, 100.0, "a number in [-100, 100]"});
    add_number(parser,
               {"--cost-scale", "N", "Steps at the end of the heat map (cost, .png)", "100"},
               request.develop.cost_scale, {0.0, infinity, "a finite number > 0", false});
    parser.get_option("--cost-scale")->default_str("by the image");
}

void add_light(CLI::App& parser, RenderRequest& request) {
    const auto read_lamp = [&request](const std::string& given) {
        if (given == "auto" || given == "none") {
            request.lamp_wish = given == "auto" ? LampWish::automatic : LampWish::none;
            return;
        }
        request.lamp_wish = LampWish::given;
        request.lamp.position = parse_vector("--light", given);
    };
    parser
        .add_option_function<std::string>("--light", read_lamp,
                                          "Where the lamp is: X,Y,Z, none, or auto: near the\n"
                                          "camera, unless the scene has light of its own")
        ->type_name("WHERE")
        ->default_str("auto");
    add_number(parser, {"--light-radius", "R", "Size of the lamp: softness of its shadows", "0"},
               request.lamp.radius, {0.0, infinity, "a finite number >= 0"});
    const auto read_sky = [&request](const std::string& given) {
        const Vec3f color = parse_vector("--sky", given);
        if (std::min({color.x, color.y, color.z}) < 0.0F) {
            throw UsageError(
                fmt::format("--sky: '{}' has a negative number; example: --sky 1,1,1", given));
        }
        request.sky = color;
    };
    parser.add_option_function<std::string>("--sky", read_sky, "Light from where no surface is")
        ->type_name("R,G,B")
        ->default_str("blue, white at the horizon");
    add_whole(parser, {"--max-depth", "N", "Reflections and bounces in a row at most", "8"},
              request.integrator_options.max_depth, 0, 1000);
    add_number(parser, {"--ao-distance", "D", "What is further away does not occlude (ao)", "0.5"},
               request.integrator_options.ao_distance,
               {0.0, infinity, "a finite number > 0", false});
    parser.get_option("--ao-distance")->default_str("a tenth of the scene");
}

void refuse_vain_image_options(const CLI::App& parser, const RenderRequest& request) {
    const render::IntegratorEntry& integrator = render::find_integrator(request.integrator);
    const auto format = render::format_of(request.out);
    const bool is_png = format == render::ImageFormat::png;
    const bool is_light = integrator.display == render::Display::light;
    const bool is_cost = integrator.display == render::Display::cost;
    refuse_vain(parser, "--exposure", !is_png, ".exr and .pfm hold the light itself; write a .png");
    refuse_vain(parser, "--cost-scale", !is_png, ".exr and .pfm hold the steps; write a .png");
    const std::string no_light =
        fmt::format("--integrator {} shows no light; whitted and path do", integrator.name);
    for (const char* const name :
         {"--exposure", "--light", "--light-radius", "--sky", "--max-depth"}) {
        refuse_vain(parser, name, !is_light, no_light);
    }
    refuse_vain(parser, "--light-radius", request.lamp_wish == LampWish::none,
                "--light none leaves no lamp");
    refuse_vain(parser, "--cost-scale", !is_cost, "only --integrator cost has a heat map");
    refuse_vain(parser, "--ao-distance", integrator.display != render::Display::share,
                "only --integrator ao goes by it");
}

void check_request(const CLI::App& parser, RenderRequest& request) {
    require_scenes(parser, request.scenes);
    if (request.scenes.size() > 1) {
        throw UsageError(
            fmt::format("render takes one scene; leave '{}' out, or render it in a run of its own",
                        request.scenes[1]));
    }
    if (request.out.empty()) {
        throw UsageError("--out: no file is given; example: --out image.png");
    }
    if (!render::format_of(request.out)) {
        throw UsageError(
            fmt::format("--out: '{}' ends in none of .png, .exr and .pfm; example: --out image.png",
                        request.out));
    }
}

}  // namespace coppice::app
