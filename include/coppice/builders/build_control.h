#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>

namespace coppice::inline v0 {

/// How a build is watched and held in check. The tree does not depend on it, but for the preset
/// that Bvh8Preset::automatic chooses under a memory limit.
struct BuildControl {
    /// Told of the share of the work that is done: 0 first, then more each time, at most a thousand
    /// times, and 1 when the build is over. Called from any thread of the build, never twice at
    /// once. An exception it throws ends the build and reaches the caller.
    std::function<void(double done)> on_progress = {};

    /// A request to stop ends the build with Error(cancelled), within milliseconds.
    std::stop_token stop = {};

    /// The most that the build's arrays may hold at once, the tree included, together with
    /// `primitive_bytes`; 0: no limit. The build is estimated first, and if it would pass the limit
    /// it fails with Error(limit) before it begins. Bvh8Preset::automatic takes the smallest preset
    /// if that keeps within it.
    std::uint64_t memory_limit_bytes = 0;
    std::uint64_t primitive_bytes = 0;  ///< what is there already and counts, too

    /// False leaves BuildReport::statistics out, which take a twentieth of the time of a build.
    bool is_measured = true;
};

}  // namespace coppice::inline v0
