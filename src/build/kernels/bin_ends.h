#pragma once

#include "coppice/build/split_finder.h"

#include <array>
#include <cstddef>
#include <span>

namespace coppice {

inline constexpr std::size_t bin_count = 32;

/// Which bin a position on an axis is in: monotone in the position.
struct BinGrid {
    Vec3f origin;
    Vec3f bins_per_unit;
};

/// The weight of the fragments that start and of those that end in each bin of an axis.
struct AxisBins {
    std::array<double, bin_count> starts{};
    std::array<double, bin_count> ends{};
};

/// The bins of all axes, and the box of the fragments themselves.
struct NodeBins {
    std::array<AxisBins, 3> axes;
    Aabb extent;
};

/// The bin of a position; those outside the grid are in the first or the last.
[[nodiscard]] inline std::size_t bin_of(float position, float origin,
                                        float bins_per_unit) noexcept {
    const auto bin = static_cast<int>((position - origin) * bins_per_unit);
    return static_cast<std::size_t>(bin < 0 ? 0 : bin > 31 ? 31 : bin);
}

/// Adds fragments to the bins.
void bin_ends(std::span<const Fragment> fragments, const BinGrid& grid, NodeBins& bins) noexcept;

}  // namespace coppice
