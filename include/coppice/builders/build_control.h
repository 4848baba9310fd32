#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>

namespace coppice::inline v0 {

/// Progress reports, cancellation and the memory limit of a build. The tree does not depend on it,
/// except for the preset that Bvh8Preset::automatic chooses under a memory limit.
struct BuildControl {
    /// Called with the share of the work that is done, in [0, 1]: first 0, then increasing values,
    /// at most a thousand of them, and 1 at the end. Called from any thread of the build, but never
    /// concurrently. An exception it throws ends the build and reaches the caller. Empty disables
    /// progress.
    std::function<void(double done)> on_progress = {};

    /// A stop request ends the build with Error(cancelled) within milliseconds.
    std::stop_token stop = {};

    /// The greatest number of bytes that the build's arrays may hold at once, together with
    /// `primitive_bytes`. Includes the tree; 0 means no limit. The build is estimated first. If it
    /// would exceed the limit, it fails with Error(limit) before it starts. Bvh8Preset::automatic
    /// uses the smallest preset if that stays within the limit.
    std::uint64_t memory_limit_bytes = 0;
    std::uint64_t primitive_bytes = 0;  ///< bytes already held that count towards the limit

    /// False skips BuildReport::statistics, which take a twentieth of the build time.
    bool is_measured = true;
};

}  // namespace coppice::inline v0
