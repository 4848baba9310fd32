#pragma once

#include "options.h"
#include "scenes/camera.h"
#include "scenes/ray_sets.h"

#include <CLI/CLI.hpp>

#include <span>
#include <vector>

namespace coppice::app {

/// --eye, --look-at, --up and --fov: what is given of a camera.
void add_camera(CLI::App& parser, render::CameraWish& camera);

/// A list of some kinds of rays, each once; `all` is all of them.
void add_ray_kinds(CLI::App& parser, const OptionText& text,
                   std::span<const lab::RayKindEntry> known, std::vector<lab::RayKind>& kinds);

}  // namespace coppice::app
