#pragma once

#include "render/camera.h"

#include <CLI/CLI.hpp>

namespace coppice::app {

/// The options of a camera: --eye, --look-at, --up and --fov. What is not given is left open.
void add_camera(CLI::App& parser, render::CameraWish& camera);

}  // namespace coppice::app
