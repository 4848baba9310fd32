#pragma once

#include "coppice/builders/bvh8_options.h"

#include <cstdint>
#include <string_view>

namespace coppice::inline v0::bvh8 {

/// The sampler of presets that draw their own sample.
inline constexpr std::string_view preset_sampler = "weighted";

/// The build parameters that follow from the options and the size of a scene.
struct Plan {
    Bvh8Preset preset;        ///< the preset chosen
    bool by_planes;           ///< true: cells by a k-d tree; false: by object splits
    std::uint32_t cell_size;  ///< target triangles per cell
    double room;              ///< greatest PrimRefs per triangle; 1: no spatial splits
    SampleOptions sampling;   ///< rate 1: the scene is not sampled
};

/// The plan for a scene of `triangle_count` triangles.
[[nodiscard]] Plan make_plan(const Bvh8Options& options, std::uint32_t triangle_count);

/// Options whose plan for a part of a scene corresponds to the plan for the whole.
[[nodiscard]] Bvh8Options scaled_down(const Bvh8Options& options, std::uint32_t triangle_count,
                                      double share);

}  // namespace coppice::inline v0::bvh8
