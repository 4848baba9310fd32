#pragma once

#include "bench/bench_options.h"
#include "scenes/camera.h"
#include "scenes/ray_sets.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coppice::lab {

/// A number for each kind of rays, by RayKind; nothing for a kind that was not asked for.
using PerRayKind = std::array<std::optional<double>, 3>;

/// One contestant on one scene with one number of threads.
struct BenchRow {
    std::string scene;
    std::uint64_t triangles = 0;
    std::string method;  ///< as it was asked for, or the peer's name
    bool is_peer = false;
    int threads = 1;
    double build_seconds = 0.0;        ///< median of the runs after the first
    double build_seconds_first = 0.0;  ///< of the first run with these threads
    double build_cpu_seconds = 0.0;    ///< median, all threads together
    double bytes_per_triangle = 0.0;
    double peak_bytes_per_triangle = 0.0;
    std::optional<double> sah_cost;
    std::optional<double> references_per_triangle;
    std::optional<double> sample_share;  ///< drawn of all primitives, in (0, 1]; not a column
    PerRayKind mrays;                    ///< million rays a second, by the median time
    double scatter = 0.0;  ///< of the runs' tracing: half their range over the median; not a column
    std::uint64_t mismatches = 0;  ///< rays, of all kinds, that do not agree with the reference
};

/// How a scene was seen, and with how many rays.
struct BenchScene {
    std::string scene;
    std::filesystem::path file;
    std::uint64_t triangles = 0;
    render::Camera camera;
    Vec3f light;
    std::string reference;                      ///< whose hits the others are compared with
    std::array<std::uint64_t, 3> ray_counts{};  ///< by RayKind
};

/// All that a benchmark measured. Rows by scene, threads, then methods before peers, as asked for.
struct BenchResult {
    std::vector<BenchScene> scenes;
    std::vector<BenchRow> rows;
};

/// The numbers of rays by the names of their kinds.
[[nodiscard]] nlohmann::ordered_json ray_counts_json(const BenchScene& scene);

/// One row as an object; what was not measured is null.
[[nodiscard]] nlohmann::ordered_json row_json(const BenchRow& row);

/// The JSON of a benchmark: `machine` with compiler and revision, `options` with each scene's
/// camera, light and rays under `views`, and `rows`.
[[nodiscard]] nlohmann::ordered_json bench_document(const BenchOptions& options,
                                                    const BenchResult& result);

/// The rows of one scene as plain text.
[[nodiscard]] std::string bench_table(const BenchScene& scene, std::span<const BenchRow> rows);

/// Our methods against Embree as plain text: build time against embree-medium, rays against
/// embree-high and embree-robust, each as how many times faster, per scene and as the geometric
/// mean of all scenes. Empty if none of these peers ran.
[[nodiscard]] std::string ratio_table(std::span<const BenchRow> rows);

}  // namespace coppice::lab
