#pragma once

#include "coppice/builders/build_options.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace coppice::inline v0 {

/// Which tree a method builds, and so by which function: build_kd_tree() or build_bvh8().
enum class TreeKind : std::uint8_t { kd, bvh8 };

/// A way to build a tree under its name, with one line on what it does.
struct Method {
    std::string_view name;      ///< how options and reports call it
    std::string_view summary;   ///< what it does, in one line
    TreeKind tree;              ///< what it builds
    BuildOptions (*options)();  ///< what the name stands for, with the costs it was tuned for
};

/// All methods, k-d trees first.
[[nodiscard]] std::span<const Method> method_registry();

/// The method of that name. Throws Error(invalid_argument) naming those that exist.
[[nodiscard]] const Method& find_method(std::string_view name);

}  // namespace coppice::inline v0
