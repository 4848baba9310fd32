#pragma once

#include "coppice/geom/triangle_mesh.h"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <string_view>

namespace coppice::test {

/// A small scene under its name, with its seed at the end where it has one.
struct NamedScene {
    std::string_view name;
    TriangleMesh (*make)();
};

/// The scenes that break builders: all of a few thousand triangles at most.
[[nodiscard]] std::span<const NamedScene> scene_matrix();

/// Names a test by its scene.
[[nodiscard]] inline std::string scene_name(const testing::TestParamInfo<NamedScene>& info) {
    return std::string(info.param.name);
}

/// For gtest's messages.
void PrintTo(const NamedScene& scene,
             std::ostream* stream);  // NOLINT(readability-identifier-naming)

}  // namespace coppice::test
