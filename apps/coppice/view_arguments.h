#pragma once

#include "options.h"
#include "scenes/camera.h"
#include "scenes/ray_sets.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coppice::app {

/// --eye, --look-at, --up and --fov: what is given of a camera.
void add_camera(CLI::App& parser, render::CameraWish& camera);

/// --size (`default_size` pixels each way, at most `max_size`), the camera and --seed: where rays
/// that are measured come from.
void add_measured_view(CLI::App& parser, const std::string& default_size, int max_size, int& size,
                       render::CameraWish& camera, std::uint64_t& seed);

/// A list of some kinds of rays, each once; `all` is all of them.
void add_ray_kinds(CLI::App& parser, const OptionText& text,
                   std::span<const lab::RayKindEntry> known, std::vector<lab::RayKind>& kinds);

/// True if there are diffuse rays, whose directions are random.
[[nodiscard]] bool has_bounces(std::span<const lab::RayKind> kinds);

/// Throws UsageError if a camera is given and none of the rays begin there.
void refuse_vain_view(const CLI::App& parser, std::span<const lab::RayKind> kinds);

}  // namespace coppice::app
