#pragma once

#include "coppice/base/cpu.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/tree/bvh8.h"

#include "builders/bvh8/prim_ref.h"
#include "builders/kernels/slabs.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace coppice::inline v0::bvh8 {

inline constexpr std::size_t max_bin_count = 16;

/// The bin of a position that is measured in bins from the first one. NaN gives the last bin.
[[nodiscard]] constexpr std::uint32_t bin_at(float place, float last_bin) noexcept {
    return static_cast<std::uint32_t>(place < last_bin ? place : last_bin);
}

/// Maps a PrimRef to a bin on each axis, by the sum lower + upper of its box: twice the centroid,
/// since halving it would not change the bin. A scale of 0 maps everything to bin 0.
struct BinMapping {
    std::array<float, 3> origin;
    std::array<float, 3> scale;
    std::uint32_t bin_count;

    /// The bin of a PrimRef on an axis.
    [[nodiscard]] std::uint32_t bin_of(const PrimRef& prim_ref, std::size_t axis) const noexcept {
        const float sum = prim_ref.upper[axis] - prim_ref.negated_lower[axis];
        return bin_at((sum - origin[axis]) * scale[axis], static_cast<float>(bin_count - 1));
    }

    /// The position where bin `bin` begins on an axis.
    [[nodiscard]] float begin_of(std::size_t axis, std::uint32_t bin) const noexcept {
        return origin[axis] + static_cast<float>(bin) / scale[axis];
    }
};

/// The box and the summed weight of the PrimRefs in each bin.
struct alignas(32) Bins {
    std::array<std::array<Box8, max_bin_count>, 3> box;
    std::array<std::array<float, max_bin_count>, 3> weight;
};

/// The cost parameters of splits. Where a block of 8 triangles costs as much as one, block_size is
/// 8.
struct SplitCosts {
    float block_size;     ///< weights are divided by this
    bool whole_blocks;    ///< the quotient is rounded up
    float extent_factor;  ///< scale of edges before areas are computed: keeps them finite
};

/// An object split: PrimRefs below bin `bin` on an axis go to one side, all others to the other.
struct ObjectSplit {
    float cost = std::numeric_limits<float>::infinity();  ///< area times blocks, both sides
    std::uint32_t axis = 0;
    std::uint32_t bin = 0;  ///< 0 if there is no split
    float lower_weight = 0.0F;
    Box8 lower_box;
    Box8 upper_box;
};

/// A border between two bins of an axis.
struct Border {
    const BinMapping& mapping;
    std::uint32_t axis;
    std::uint32_t bin;  ///< the bin above the border
};

/// A pair of values, one for each side of a border.
template <typename T>
struct Sides {
    T lower;
    T upper;
};

/// The box of PrimRefs and the range of their centroids.
struct Measure {
    Box8 box = Box8::make_empty();
    Box8 centroids = Box8::make_empty();
};

/// The arrays of a mesh.
struct MeshArrays {
    const Vec3f* vertices;
    const TriangleIndices* triangles;
};

/// The corner of lanes without a triangle. No ray hits it.
inline constexpr Vec3f nowhere{std::numeric_limits<float>::quiet_NaN(),
                               std::numeric_limits<float>::quiet_NaN(),
                               std::numeric_limits<float>::quiet_NaN()};

inline constexpr Box8 empty_box = Box8::make_empty();

/// The inner loops of the 8-wide builder for one instruction set. All sets give equal results to
/// the bit.
struct Kernels {
    /// The box of PrimRefs and the range of their centroids.
    void (*unite)(std::span<const PrimRef>, Box8& box, Box8& centroids) noexcept;

    /// Adds PrimRefs to bins.
    void (*bin)(std::span<const PrimRef>, const BinMapping&, Bins&) noexcept;

    /// The cheapest split between bins; bin 0 if all PrimRefs are in one bin.
    ObjectSplit (*find_split)(const Bins&, std::uint32_t bin_count, const SplitCosts&) noexcept;

    /// Copies PrimRefs to the two sides of a border, keeping their order, and computes the centroid
    /// bounds of both sides.
    void (*partition)(std::span<const PrimRef>, const Border&, Sides<PrimRef*> out,
                      Sides<Box8>& centroids) noexcept;

    /// Clips every `stride`-th triangle to the slabs of each axis, and adds the pieces to the
    /// slabs' contents.
    void (*bin_pieces)(std::span<const PrimRef>, std::size_t stride, const MeshArrays&,
                       const Slabs&, std::array<SlabContents, 3>&) noexcept;

    /// Counts the PrimRefs with a piece on each side of a plane.
    Sides<std::uint32_t> (*count_pieces)(std::span<const PrimRef>, const MeshArrays&,
                                         CutPlane) noexcept;

    /// Copies PrimRefs to the two sides of a plane, keeping their order, each with the box of its
    /// piece on that side.
    void (*write_pieces)(std::span<const PrimRef>, const MeshArrays&, CutPlane, Sides<PrimRef*> out,
                         Sides<Measure>&) noexcept;

    /// Copies the corners of up to eight triangles into a block.
    void (*fill_block)(std::span<const std::uint32_t> ids, const MeshArrays&,
                       TriangleBlock&) noexcept;
};

/// The kernels for an instruction set, which this processor must support.
[[nodiscard]] const Kernels& kernels_for(Isa isa) noexcept;

/// Empties the first `bin_count` bins.
void clear(Bins& bins, std::uint32_t bin_count) noexcept;

}  // namespace coppice::inline v0::bvh8
