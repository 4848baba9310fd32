#pragma once

#include "coppice/builders/build_options.h"
#include "coppice/export.h"

#include <span>
#include <string_view>

namespace coppice::inline v0 {

/// A way to build a tree under its name, with one line on what it does.
struct COPPICE_EXPORT Method {
    std::string_view name;      ///< how options and reports call it
    std::string_view summary;   ///< what it does, in one line
    BuildOptions (*options)();  ///< what the name stands for, with the costs it was tuned for

    /// The same for build_kd_tree(). Throws Error(invalid_argument) for a method of 8-wide trees.
    [[nodiscard]] KdOptions kd_options() const;

    /// The same for build_bvh8(). Throws Error(invalid_argument) for a method of k-d trees.
    [[nodiscard]] Bvh8Options bvh8_options() const;

    /// What it builds.
    [[nodiscard]] TreeKind tree() const { return tree_kind(options()); }

    /// True if its trees begin with a sample, and so depend on sampler, rate and seed.
    [[nodiscard]] bool uses_sample() const { return sample_of(options()).rate < 1.0; }

    /// True for the method that chooses another one by the scene and the rays expected.
    [[nodiscard]] bool is_automatic() const;
};

/// All methods, k-d trees first.
[[nodiscard]] COPPICE_EXPORT std::span<const Method> method_registry();

/// The method of that name. Throws Error(invalid_argument) naming those that exist.
[[nodiscard]] COPPICE_EXPORT const Method& find_method(std::string_view name);

}  // namespace coppice::inline v0
