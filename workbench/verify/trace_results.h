#pragma once

#include "coppice/builders/build_report.h"
#include "coppice/geom/ray.h"

#include "scenes/camera.h"
#include "verify/exact_judge.h"
#include "verify/trace_options.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coppice::lab {

/// How a number is distributed over rays.
struct Distribution {
    double mean = 0.0;
    std::uint32_t p50 = 0;
    std::uint32_t p90 = 0;
    std::uint32_t p99 = 0;
    std::uint32_t max = 0;
};

/// What the traversal of one ray visits, over all rays of a kind.
struct CountSummary {
    Distribution nodes;
    Distribution leaves;
    Distribution primitives;
};

/// A ray that two tracers do not agree on, with what is true. Misses have an infinite t.
struct TraceDifference {
    Ray ray;
    std::size_t index = 0;  ///< of the ray among those of its kind
    Hit ours;
    Hit reference;
    std::optional<ExactHit> exact;
    bool is_ours_right = false;
    bool is_reference_right = false;
};

/// How our hits compare with a reference's.
struct TraceComparison {
    std::uint64_t ties = 0;             ///< the same t by 1e-5 of it, but another triangle
    std::uint64_t hit_miss = 0;         ///< one hits, the other does not
    std::uint64_t distance = 0;         ///< t differs by more
    std::uint64_t ours_right = 0;       ///< of those of the last two kinds
    std::uint64_t reference_right = 0;  ///< likewise; both may be, where t differs by little more
    std::uint64_t ours_wrong = 0;       ///< what must be 0
    std::vector<TraceDifference> examples;  ///< the first few of the last two kinds
};

/// One kind of rays in one scene.
struct TraceRow {
    RayKind kind = RayKind::primary;
    std::uint64_t rays = 0;
    std::uint64_t hits = 0;
    double seconds = 0.0;  ///< of tracing them once
    std::optional<CountSummary> counts;
    std::optional<TraceComparison> comparison;
};

/// One scene with what was traced in it.
struct TraceScene {
    std::string scene;
    std::filesystem::path file;
    std::uint64_t triangles = 0;
    double build_seconds = 0.0;    ///< or to load it
    std::string method;            ///< of the tree
    std::vector<BuildNote> notes;  ///< on options that had no effect on its build
    render::Camera camera;
    Vec3f light;
    std::vector<TraceRow> rows;
};

/// The distribution of some numbers, which are put into another order. At least one.
[[nodiscard]] Distribution distribution_of(std::span<std::uint32_t> numbers);

/// One scene as plain text: speeds, counts, and every difference from the reference examined.
[[nodiscard]] std::string trace_text(const TraceOptions& options, const TraceScene& scene);

/// The JSON of a run: `machine`, `options` and `scenes` with their rows.
[[nodiscard]] nlohmann::ordered_json trace_document(const TraceOptions& options,
                                                    std::span<const TraceScene> scenes);

}  // namespace coppice::lab
