#pragma once

#include "coppice/builders/split_finder.h"

#include <array>
#include <cstddef>

namespace coppice::inline v0 {

inline constexpr std::size_t bin_count = 32;

/// Maps positions to bins on each axis; monotonic in the position.
struct BinGrid {
    Vec3f origin;
    Vec3f bins_per_unit;
};

/// The weights and extreme positions of PrimRefs that start and end in each bin of an axis.
struct AxisBins {
    AxisBins() noexcept {
        first_start.fill(Aabb::infinity);
        last_end.fill(-Aabb::infinity);
    }

    void add_start(std::size_t bin, float position, double weight) noexcept {
        starts[bin] += weight;
        first_start[bin] = position < first_start[bin] ? position : first_start[bin];
    }

    void add_end(std::size_t bin, float position, double weight) noexcept {
        ends[bin] += weight;
        last_end[bin] = position > last_end[bin] ? position : last_end[bin];
    }

    friend bool operator==(const AxisBins&, const AxisBins&) = default;

    std::array<double, bin_count> starts{};  ///< weight of the PrimRefs that start in a bin
    std::array<double, bin_count> ends{};
    std::array<float, bin_count> first_start;  ///< least start in a bin; infinite if none
    std::array<float, bin_count> last_end;
};

/// The bins of all axes.
using NodeBins = std::array<AxisBins, 3>;

/// The bin of a position. Positions outside the grid are in the first or last bin.
[[nodiscard]] inline std::size_t bin_of(float position, float origin,
                                        float bins_per_unit) noexcept {
    const auto bin = static_cast<int>((position - origin) * bins_per_unit);
    return static_cast<std::size_t>(bin < 0 ? 0 : bin > 31 ? 31 : bin);
}

}  // namespace coppice::inline v0
