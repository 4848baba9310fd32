#include "view_arguments.h"

#include "options.h"

namespace coppice::app {

void add_camera(CLI::App& parser, render::CameraWish& camera) {
    add_vector(parser, {"--eye", "X,Y,Z", "Where the camera is", "all in view"}, camera.eye);
    add_vector(parser, {"--look-at", "X,Y,Z", "What it looks at", "the middle"}, camera.look_at);
    add_vector(parser, {"--up", "X,Y,Z", "What is up in the image", "y, of flat scenes z"},
               camera.up);
    add_number(parser, {"--fov", "DEGREES", "Field of view from bottom to top", "45"}, camera.fov,
               {0.0, 180.0, "a number in (0, 180)", false, false});
}

}  // namespace coppice::app
