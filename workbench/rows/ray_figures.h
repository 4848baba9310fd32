#pragma once

#include "scenes/ray_sets.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace coppice::lab {

/// The tree that all others of an experiment take turns with, and whose hits theirs are compared
/// with: a name in method_registry().
inline constexpr std::string_view reference_method = "fast";

/// What the traversal of one ray visits, on average.
struct MeanSteps {
    double nodes = 0.0;  ///< inner ones
    double leaves = 0.0;
    double primitives = 0.0;

    friend bool operator==(const MeanSteps&, const MeanSteps&) = default;
};

/// One kind of rays traced through one tree.
struct RayFigures {
    RayKind kind = RayKind::primary;
    std::uint64_t rays = 0;          ///< at least one
    double wall_seconds = 0.0;       ///< of all rays, on all threads; a median of several runs
    std::optional<MeanSteps> steps;  ///< nothing for peers
    std::uint64_t mismatches = 0;    ///< rays whose hits are not the reference's
    double reference_seconds = 0.0;  ///< of the reference's runs, in turns with these
    double drift = 1.0;              ///< the reference's, of the tree: is out of wall_seconds

    /// Million rays a second.
    [[nodiscard]] double mrays() const { return 1e-6 * static_cast<double>(rays) / wall_seconds; }

    /// Nanoseconds of wall-clock time a ray.
    [[nodiscard]] double nanoseconds() const {
        return 1e9 * wall_seconds / static_cast<double>(rays);
    }

    friend bool operator==(const RayFigures&, const RayFigures&) = default;
};

/// Nanoseconds of wall-clock time a ray, over all kinds in their numbers; nothing if there are no
/// rays.
[[nodiscard]] inline std::optional<double> nanoseconds_of(std::span<const RayFigures> all) {
    double seconds = 0.0;
    double rays = 0.0;
    for (const RayFigures& figures : all) {
        seconds += figures.wall_seconds;
        rays += static_cast<double>(figures.rays);
    }
    return rays > 0.0 ? std::optional(1e9 * seconds / rays) : std::nullopt;
}

}  // namespace coppice::lab
