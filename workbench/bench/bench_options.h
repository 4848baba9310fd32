#pragma once

#include "scenes/camera.h"
#include "scenes/ray_sets.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace coppice::lab {

/// What a benchmark runs: every scene with every number of threads, method and peer.
struct BenchOptions {
    static constexpr int max_runs = 1000;
    static constexpr int max_size = 8192;

    std::vector<std::filesystem::path> scenes;
    std::vector<std::string> methods;  ///< distinct, each for find_variant()
    std::vector<std::string> peers;    ///< distinct names of peer_registry()
    std::vector<int> threads{1, 2};    ///< distinct, each >= 1
    int runs = 5;                      ///< measured runs after the first, in [1, max_runs]
    std::vector<RayKind> rays{RayKind::primary, RayKind::shadow, RayKind::diffuse};
    bool is_batched = false;               ///< rays are handed over in arrays, not one by one
    int size = 1024;                       ///< of the image, in pixels each way, in [1, max_size]
    render::CameraWish camera;             ///< for all scenes
    std::uint64_t seed = 1;                ///< of the bounces' directions
    std::uint64_t memory_limit_bytes = 0;  ///< of a scene and a build of ours; 0: none
};

/// Throws Error(invalid_argument) naming the first option that is outside its range.
void check(const BenchOptions& options);

/// Serializes the options as one flat object under the names that the program's options have.
void to_json(nlohmann::json& json, const BenchOptions& options);

}  // namespace coppice::lab
