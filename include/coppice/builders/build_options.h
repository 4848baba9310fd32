#pragma once

#include "coppice/builders/bvh8_options.h"
#include "coppice/builders/kd_options.h"
#include "coppice/export.h"

#include <cstdint>
#include <variant>

namespace coppice::inline v0 {

/// Which tree is built, and so by which function: build_kd_tree() or build_bvh8().
enum class TreeKind : std::uint8_t { kd, bvh8 };

/// The options of either builder, for programs that choose it at run time.
using BuildOptions = std::variant<KdOptions, Bvh8Options>;

/// The kind of tree that the options are for.
[[nodiscard]] inline TreeKind tree_kind(const BuildOptions& options) noexcept {
    return std::holds_alternative<KdOptions>(options) ? TreeKind::kd : TreeKind::bvh8;
}

// What both kinds have.

/// How the sample is drawn.
[[nodiscard]] COPPICE_EXPORT const SampleOptions& sample_of(const BuildOptions& options) noexcept;

/// How the sample is drawn, to change it.
[[nodiscard]] COPPICE_EXPORT SampleOptions& sample_of(BuildOptions& options) noexcept;

/// The costs that the finished tree is measured by.
[[nodiscard]] COPPICE_EXPORT const SahCostModel& cost_of(const BuildOptions& options) noexcept;

/// The costs that the finished tree is measured by, to change them.
[[nodiscard]] COPPICE_EXPORT SahCostModel& cost_of(BuildOptions& options) noexcept;

/// The limit on threads; 0 for all that the process may use.
[[nodiscard]] COPPICE_EXPORT int threads_of(const BuildOptions& options) noexcept;

/// Limits the threads; 0 for all that the process may use.
COPPICE_EXPORT void set_threads(BuildOptions& options, int threads) noexcept;

}  // namespace coppice::inline v0
