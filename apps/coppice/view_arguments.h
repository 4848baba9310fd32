#pragma once

#include "render/camera.h"

#include <CLI/CLI.hpp>

namespace coppice::app {

/// --eye, --look-at, --up and --fov: what is given of a camera.
void add_camera(CLI::App& parser, render::CameraWish& camera);

}  // namespace coppice::app
