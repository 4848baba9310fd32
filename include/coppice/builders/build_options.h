#pragma once

#include "coppice/builders/bvh8_options.h"
#include "coppice/builders/kd_options.h"
#include "coppice/export.h"

#include <cstdint>
#include <variant>

namespace coppice::inline v0 {

/// The kind of tree: `kd` is built by build_kd_tree(), `bvh8` by build_bvh8().
enum class TreeKind : std::uint8_t { kd, bvh8 };

/// The options of either builder, for programs that choose the builder at run time.
using BuildOptions = std::variant<KdOptions, Bvh8Options>;

/// The kind of tree that the options describe.
[[nodiscard]] inline TreeKind tree_kind(const BuildOptions& options) noexcept {
    return std::holds_alternative<KdOptions>(options) ? TreeKind::kd : TreeKind::bvh8;
}

// Access to the options that both kinds have.

/// The sampling options of either kind.
[[nodiscard]] COPPICE_EXPORT const SampleOptions& sample_of(const BuildOptions& options) noexcept;

/// The sampling options of either kind, to be modified.
[[nodiscard]] COPPICE_EXPORT SampleOptions& sample_of(BuildOptions& options) noexcept;

/// The cost model of either kind. The finished tree is measured with it.
[[nodiscard]] COPPICE_EXPORT const SahCostModel& cost_of(const BuildOptions& options) noexcept;

/// The cost model of either kind, to be modified.
[[nodiscard]] COPPICE_EXPORT SahCostModel& cost_of(BuildOptions& options) noexcept;

/// The greatest number of threads; 0 = all hardware threads.
[[nodiscard]] COPPICE_EXPORT int threads_of(const BuildOptions& options) noexcept;

/// Sets the greatest number of threads; 0 = all hardware threads.
COPPICE_EXPORT void set_threads(BuildOptions& options, int threads) noexcept;

}  // namespace coppice::inline v0
