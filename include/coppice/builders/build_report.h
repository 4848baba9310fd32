#pragma once

#include "coppice/builders/build_options.h"
#include "coppice/cost/tree_statistics.h"
#include "coppice/export.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coppice::inline v0 {

/// Times and output size of one stage of a build.
struct StageReport {
    double wall_seconds = 0.0;  ///< wall-clock time of the stage
    double cpu_seconds = 0.0;   ///< CPU time of all threads of the process
    std::uint64_t items = 0;    ///< number of results, see StageReports
};

/// The five stages of a build. A stage with nothing to do is all 0. For example, a tree of all
/// primitives that is split until no split pays is complete after the second stage.
struct StageReports {
    StageReport sample;  ///< items: primitives drawn
    StageReport build;   ///< items: nodes of the sampled tree
    StageReport empty;   ///< items: nodes kept
    StageReport refill;  ///< items: references
    StageReport refine;  ///< items: references

    /// Of all stages together.
    [[nodiscard]] constexpr double wall_seconds() const noexcept {
        return sample.wall_seconds + build.wall_seconds + empty.wall_seconds + refill.wall_seconds +
               refine.wall_seconds;
    }

    /// Of all stages together.
    [[nodiscard]] constexpr double cpu_seconds() const noexcept {
        return sample.cpu_seconds + build.cpu_seconds + empty.cpu_seconds + refill.cpu_seconds +
               refine.cpu_seconds;
    }
};

/// The expected size and time of a build, computed before it.
struct BuildEstimate {
    double references = 0.0;  ///< references of the finished tree
    double bytes = 0.0;       ///< bytes of the finished tree
    double peak_bytes = 0.0;  ///< peak bytes of the build's arrays, tree included
    double seconds = 0.0;     ///< wall-clock time of the build
};

/// An option that had no effect in a build, or another effect than it says, with the reason.
struct BuildNote {
    std::string option;  ///< name of the option, e.g. "sample.rate"
    std::string reason;  ///< e.g. "replaced by split.custom_rule"

    friend bool operator==(const BuildNote&, const BuildNote&) = default;
};

/// What a build was asked to do, what it did, why they differ, and the statistics of the tree.
struct BuildReport {
    BuildOptions options;  ///< options as passed to the build
    std::string method;    ///< name in method_registry(), or empty
    SampleOptions sample;  ///< sampling as done; rate 1 if all primitives were used
    Bvh8Preset preset = Bvh8Preset::automatic;  ///< preset that an 8-wide tree was built with
    std::string preset_reason;          ///< why `automatic` had to use a smaller preset, or empty
    std::vector<BuildNote> notes;       ///< options without effect; see notes_on()
    std::uint32_t primitive_count = 0;  ///< primitives in the tree
    std::uint32_t sample_count = 0;     ///< primitives drawn for the sample
    StageReports stages;                ///< times of the stages
    std::uint64_t tree_bytes = 0;       ///< bytes of the finished tree
    std::uint64_t peak_bytes = 0;       ///< peak bytes of the build's arrays, the tree included
    std::optional<BuildEstimate> estimate;  ///< made before the build, if one was
    TreeStatistics statistics;  ///< of the finished tree; all 0 unless BuildControl::is_measured
};

/// Returns the options that would have no effect on a build of `primitive_count` primitives, or
/// another effect than they say. Only options that differ from their defaults are considered.
[[nodiscard]] COPPICE_EXPORT std::vector<BuildNote> notes_on(const KdOptions& options,
                                                             std::uint32_t primitive_count);

/// Returns the options that would have no effect on a build of an 8-wide tree over
/// `primitive_count` triangles, or another effect than they say.
[[nodiscard]] COPPICE_EXPORT std::vector<BuildNote> notes_on(const Bvh8Options& options,
                                                             std::uint32_t primitive_count);

}  // namespace coppice::inline v0
