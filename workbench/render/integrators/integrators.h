#pragma once

#include "render/integrator.h"

#include <memory>

namespace coppice::render {

/// Light of lamps and emitters, highlights, and mirrors.
[[nodiscard]] std::unique_ptr<Integrator> make_whitted(const IntegratorOptions& options);

/// How open a surface is: 1 where nothing is near, 0 in the deepest corner; 1 where there is none.
[[nodiscard]] std::unique_ptr<Integrator> make_ambient_occlusion(const IntegratorOptions& options);

/// All light that reaches the camera over diffuse surfaces and mirrors.
[[nodiscard]] std::unique_ptr<Integrator> make_path(const IntegratorOptions& options);

/// Normals, turned to the camera, in [-1, 1]; 0 where there is nothing.
[[nodiscard]] std::unique_ptr<Integrator> make_normal(const IntegratorOptions& options);

/// Distances from the camera, of those samples that meet something; 0 if none does.
[[nodiscard]] std::unique_ptr<Integrator> make_depth(const IntegratorOptions& options);

/// Nodes that a ray visits, leaves included; primitives that it tests; the sum of both.
[[nodiscard]] std::unique_ptr<Integrator> make_cost(const IntegratorOptions& options);

}  // namespace coppice::render
