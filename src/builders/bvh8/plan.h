#pragma once

#include "coppice/builders/bvh8_options.h"

#include <cstdint>
#include <string_view>

namespace coppice::inline v0::bvh8 {

/// By which sampler presets draw samples of their own.
inline constexpr std::string_view preset_sampler = "weighted";

/// What the options come to for a scene of a certain size.
struct Plan {
    Bvh8Preset preset;        ///< the one chosen
    bool by_planes;           ///< cells by a k-d tree, else by object splits
    std::uint32_t cell_size;  ///< triangles a cell is to hold
    double room;              ///< PrimRefs a triangle at most, for spatial splits; 1: none
    SampleOptions sampling;   ///< rate 1: the scene is not sampled
};

/// The plan for a scene of so many triangles.
[[nodiscard]] Plan make_plan(const Bvh8Options& options, std::uint32_t triangle_count);

/// Options whose plan for a share of a scene is that for the whole, in small.
[[nodiscard]] Bvh8Options scaled_down(const Bvh8Options& options, std::uint32_t triangle_count,
                                      double share);

}  // namespace coppice::inline v0::bvh8
