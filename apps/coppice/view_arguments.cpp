#include "view_arguments.h"

#include "options.h"

namespace coppice::app {

void add_camera(CLI::App& parser, render::CameraWish& camera) {
    add_vector(parser, {"--eye", "X,Y,Z", "Where the camera is", "all in view, or in the room"},
               camera.eye);
    add_vector(parser, {"--look-at", "X,Y,Z", "What it looks at", "the middle"}, camera.look_at);
    add_vector(parser, {"--up", "X,Y,Z", "What is up in the image", "y, of flat scenes z"},
               camera.up);
    const auto read_fov = [&camera](const std::string& given) {
        camera.fov =
            parse_number("--fov", given, {0.0, 180.0, "a number in (0, 180)", false, false}, "45");
    };
    parser.add_option_function<std::string>("--fov", read_fov, "Field of view from bottom to top")
        ->type_name("DEGREES")
        ->default_str("45; in a room 60");
}

}  // namespace coppice::app
