#include "bench/bench_options.h"

#include "coppice/base/error.h"
#include "coppice/base/named.h"

#include "tracers/contestant.h"
#include "tracers/variant.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace coppice::lab {

namespace {

void require(bool holds, const char* name, double value, const char* range) {
    if (holds) return;
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{} {} is outside {}", name, value, range));
}

nlohmann::json vector_json(const std::optional<Vec3f>& v) {
    if (!v) return nullptr;
    return nlohmann::json::array({v->x, v->y, v->z});
}

}  // namespace

void check(const BenchOptions& options) {
    for (const std::string& name : options.methods) {
        static_cast<void>(find_variant(name));
    }
    for (const std::string& name : options.peers) {
        static_cast<void>(find_named(peer_registry(), name, "peer"));
    }
    if (options.methods.empty() && options.peers.empty()) {
        throw Error(ErrorCode::invalid_argument,
                    "nothing to measure: give at least one method or peer");
    }
    for (const int threads : options.threads) {
        require(threads >= 1, "threads", threads, "[1, 2^31)");
    }
    require(options.runs >= 1 && options.runs <= BenchOptions::max_runs, "runs", options.runs,
            "[1, 1000]");
    require(options.size >= 1 && options.size <= BenchOptions::max_size, "size", options.size,
            "[1, 8192]");
    const double fov = options.camera.fov.value_or(render::default_fov);
    require(fov > 0.0 && fov < 180.0, "fov", fov, "(0, 180)");
}

void to_json(nlohmann::json& json, const BenchOptions& options) {
    std::vector<std::string> scenes;
    for (const std::filesystem::path& scene : options.scenes) {
        scenes.push_back(scene.string());
    }
    std::vector<std::string_view> rays;
    for (const RayKindEntry& entry : rendering_ray_kinds()) {
        const bool is_asked = std::count(options.rays.begin(), options.rays.end(), entry.kind) > 0;
        if (is_asked) rays.push_back(entry.name);
    }
    json = {{"scenes", scenes},
            {"methods", options.methods},
            {"peers", options.peers},
            {"threads", options.threads},
            {"runs", options.runs},
            {"rays", rays},
            {"batched", options.is_batched},
            {"size", options.size},
            {"eye", vector_json(options.camera.eye)},
            {"look_at", vector_json(options.camera.look_at)},
            {"up", vector_json(options.camera.up)},
            {"fov", options.camera.fov ? nlohmann::json(*options.camera.fov) : nlohmann::json()},
            {"seed", options.seed}};
    if (options.memory_limit_bytes > 0) json["memory_limit_bytes"] = options.memory_limit_bytes;
}

}  // namespace coppice::lab
