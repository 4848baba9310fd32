#pragma once

#include "coppice/builders/build_options.h"

#include "scenes/camera.h"
#include "scenes/ray_sets.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace coppice::lab {

/// What hits are compared with.
enum class TraceCheck {
    none,
    embree,  ///< Embree's robust mode
    brute    ///< every triangle tested, by our own test
};

/// The stable lower-case name.
[[nodiscard]] std::string_view name_of(TraceCheck check) noexcept;

/// What is traced: in every scene all kinds of rays, against one tree.
struct TraceOptions {
    static constexpr int max_size = 8192;

    std::vector<std::filesystem::path> scenes;
    std::string method = "auto";         ///< a name of method_registry()
    BuildOptions build = Bvh8Options{};  ///< of that method, with what is to be different
    std::filesystem::path tree;          ///< a saved tree instead, of the one scene
    std::vector<RayKind> rays{RayKind::primary, RayKind::shadow, RayKind::diffuse,
                              RayKind::random,  RayKind::axis,   RayKind::grazing};
    int size = 1000;            ///< rays of each kind, squared: pixels of the image, each way
    render::CameraWish camera;  ///< for all scenes
    std::uint64_t seed = 1;     ///< of the rays
    TraceCheck check = TraceCheck::none;
    std::uint64_t memory_limit_bytes = 0;  ///< of scene and build; 0: none
    bool counts = false;                   ///< count what the traversal does
};

}  // namespace coppice::lab
