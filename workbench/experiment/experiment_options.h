#pragma once

#include "coppice/builders/kd_options.h"

#include "scenes/camera.h"
#include "scenes/ray_sets.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::lab {

/// What of a scene the trees are built over.
enum class PrimitiveKind {
    points,    ///< the distinct vertices, shuffled: the thesis's primitives
    triangles  ///< the triangles
};

/// A kind of primitive under its name, with one line on what it is.
struct PrimitiveKindEntry {
    std::string_view name;
    std::string_view summary;
    PrimitiveKind kind;
};

/// All kinds of primitives, in the order in which they are run by default.
[[nodiscard]] std::span<const PrimitiveKindEntry> primitive_kind_registry();

/// The stable lower-case name, e.g. "points".
[[nodiscard]] std::string_view name_of(PrimitiveKind kind) noexcept;

/// What the report of an experiment has.
enum class ReportParts {
    all,
    numbers  ///< no pictures and no tree inspector, which take two builds a scene
};

/// What an experiment runs: every scene with every kind, protocol or method, sampler, seed 1 ..
/// seed_count and rate.
struct ExperimentOptions {
    static constexpr int max_seed_count = 1000;
    static constexpr int max_size = 8192;

    std::vector<std::filesystem::path> scenes;
    std::vector<PrimitiveKind> primitives;  ///< distinct; empty = all that a scene has
    std::vector<std::string> protocols{"fixed", "scaled", "grown"};  ///< distinct names
    std::vector<std::string> methods;  ///< distinct names of experiment_methods()
    /// Distinct names; empty = the first of sampler_registry(), and a method's own.
    std::vector<std::string> samplers;
    /// Sample rates in percent, distinct, each in (0, 100]. The defaults are the thesis's.
    std::vector<double> percents{100, 50, 40, 30, 20, 10, 5, 4, 3, 2, 1};
    int seed_count = 1;  ///< in [1, max_seed_count]
    double tolerance =
        0.02;  ///< share of the full tree's cost that a recommended one may add; >= 0
    std::vector<RayKind> rays;  ///< distinct; to trace each tree of triangles with, or none
    int size = 256;             ///< size * size rays of each kind; in [1, max_size]
    render::CameraWish camera;  ///< for all scenes
    /// What all builds share. Each build's sampler, rate, seed, leaf limit and growth are set by
    /// its protocol; methods take only costs and threads from here.
    KdOptions build;
    /// What a scene and a build of ours may take; trees that would take more are left out. 0: none
    std::uint64_t memory_limit_bytes = 0;
    ReportParts report_parts = ReportParts::all;
    std::filesystem::path out;  ///< the folder for the results; recorded, not written to by the run
};

/// Throws Error(invalid_argument) naming the first option that is outside its range.
void check(const ExperimentOptions& options);

/// Serializes the options as one flat object under the names that the program's options have;
/// `threads` is the resolved number, `primitives` and `samplers` (of protocols) the resolved list.
void to_json(nlohmann::json& json, const ExperimentOptions& options);

/// The options as they were given, so that a run can be begun again: as to_json(), and empty lists
/// of primitives and samplers stay empty.
[[nodiscard]] nlohmann::json given_options_json(const ExperimentOptions& options);

/// The options that given_options_json() made `json` of. Throws nlohmann::json::exception for what
/// is no such object, and Error(invalid_argument) for names that are not there.
[[nodiscard]] ExperimentOptions experiment_options_of(const nlohmann::json& json);

}  // namespace coppice::lab
