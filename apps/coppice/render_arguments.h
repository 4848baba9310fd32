#pragma once

#include "build_arguments.h"
#include "render/develop.h"
#include "render/render.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace coppice::app {

/// Where the lamp is to be.
enum class LampWish { automatic, none, given };

/// The options as the parser fills them in.
struct RenderRequest {
    std::vector<std::string> scenes;
    std::string out;
    std::string integrator{"whitted"};
    render::IntegratorOptions integrator_options{.ao_distance = 0.0};  // 0: by the scene's size
    render::RenderOptions options;
    render::CameraWish camera;
    LampWish lamp_wish = LampWish::automatic;
    render::Lamp lamp;
    std::optional<Vec3f> sky;
    render::DevelopOptions develop{.cost_scale = 0.0};  // 0: by the image
    MethodRequest build;
    std::string tree;
    bool as_json = false;
};

/// --out, --integrator and what belongs to the image.
void add_image(CLI::App& parser, RenderRequest& request);

/// Lamp, sky and how far light goes.
void add_light(CLI::App& parser, RenderRequest& request);

/// Throws UsageError for an option that has no effect with the integrator or the kind of file
/// given.
void refuse_vain_image_options(const CLI::App& parser, const RenderRequest& request);

/// Throws UsageError for a request without a scene or without a file that an image can be written
/// to, or with several scenes.
void check_request(const CLI::App& parser, RenderRequest& request);

}  // namespace coppice::app
