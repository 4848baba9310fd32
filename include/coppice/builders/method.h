#pragma once

#include "coppice/builders/build_options.h"
#include "coppice/export.h"

#include <span>
#include <string_view>

namespace coppice::inline v0 {

/// A named set of build options.
struct COPPICE_EXPORT Method {
    std::string_view name;      ///< name in options and reports
    std::string_view summary;   ///< what it does, in one line
    BuildOptions (*options)();  ///< options of the method, with the costs it was tuned for

    /// The options for build_kd_tree(). Throws Error(invalid_argument) for a method of 8-wide
    /// trees.
    [[nodiscard]] KdOptions kd_options() const;

    /// The options for build_bvh8(). Throws Error(invalid_argument) for a method of k-d trees.
    [[nodiscard]] Bvh8Options bvh8_options() const;

    /// The kind of tree it builds.
    [[nodiscard]] TreeKind tree() const { return tree_kind(options()); }

    /// True if its trees are built from a sample, and so depend on sampler, rate and seed.
    [[nodiscard]] bool uses_sample() const { return sample_of(options()).rate < 1.0; }

    /// True for the method that chooses a preset by the scene and the expected number of rays.
    [[nodiscard]] bool is_automatic() const;
};

/// All methods, k-d trees first.
[[nodiscard]] COPPICE_EXPORT std::span<const Method> method_registry();

/// The method called `name`. Throws Error(invalid_argument) with a list of the valid names if there
/// is none.
[[nodiscard]] COPPICE_EXPORT const Method& find_method(std::string_view name);

}  // namespace coppice::inline v0
