#pragma once

#include <string_view>

namespace coppice::lab {

/// What comes out of a builder, and so what its cost counts and how it is traced.
enum class TreeForm {
    kd,    ///< a k-d tree; the cost is per primitive
    bvh8,  ///< an 8-wide tree of triangles; the cost is per block of eight
    peer   ///< another library's structure, over triangles; its cost is not known
};

/// The stable lower-case name, e.g. "kd".
[[nodiscard]] constexpr std::string_view name_of(TreeForm form) noexcept {
    return form == TreeForm::kd ? "kd" : form == TreeForm::bvh8 ? "bvh8" : "peer";
}

}  // namespace coppice::lab
