#pragma once

#include "coppice/builders/build_options.h"
#include "coppice/cost/tree_statistics.h"
#include "coppice/export.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coppice::inline v0 {

/// What one stage of a build took, and how much came out of it.
struct StageReport {
    double wall_seconds = 0.0;  ///< from its begin to its end
    double cpu_seconds = 0.0;   ///< of all threads of the process
    std::uint64_t items = 0;    ///< see StageReports
};

/// The five stages of a build. One that had nothing to do is all 0: a tree of all primitives that
/// is built until no split pays is finished after the second.
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

/// What a build is expected to come to, told before it.
struct BuildEstimate {
    double references = 0.0;  ///< of the finished tree
    double bytes = 0.0;       ///< of the tree
    double peak_bytes = 0.0;  ///< of the build's arrays, the tree included
    double seconds = 0.0;     ///< wall clock
};

/// An option that was asked for and had no effect, or another one, and why.
struct BuildNote {
    std::string option;  ///< its name, e.g. "sample.rate"
    std::string reason;  ///< e.g. "max_leaf limits nothing where termination is sah"

    friend bool operator==(const BuildNote&, const BuildNote&) = default;
};

/// What a build was asked for, what it did, why they differ, and the measured tree.
struct BuildReport {
    BuildOptions options;  ///< as asked for
    std::string method;    ///< the name in method_registry(), if it was built by name
    SampleOptions sample;  ///< as it was drawn; a rate of 1 if all primitives were taken
    Bvh8Preset preset = Bvh8Preset::automatic;  ///< that an 8-wide tree was built by
    std::string preset_reason;  ///< why it is a smaller one than `automatic` had chosen, or nothing
    std::vector<BuildNote> notes;       ///< on what was asked for and not done; see notes_on()
    std::uint32_t primitive_count = 0;  ///< over which the tree is built
    std::uint32_t sample_count = 0;     ///< drawn from them
    StageReports stages;                ///< what each of them took
    std::uint64_t tree_bytes = 0;       ///< of the finished tree
    std::uint64_t peak_bytes = 0;  ///< the most that the build's arrays held, the tree included
    std::optional<BuildEstimate> estimate;  ///< if one was asked for before the build
    TreeStatistics statistics;  ///< of the finished tree; all 0 unless BuildControl::is_measured
};

/// The options that have no effect on a build of `primitive_count` primitives, or another than they
/// ask for. What is left at its default is not asked for.
[[nodiscard]] COPPICE_EXPORT std::vector<BuildNote> notes_on(const KdOptions& options,
                                                             std::uint32_t primitive_count);

/// The same for the 8-wide tree.
[[nodiscard]] COPPICE_EXPORT std::vector<BuildNote> notes_on(const Bvh8Options& options,
                                                             std::uint32_t primitive_count);

}  // namespace coppice::inline v0
