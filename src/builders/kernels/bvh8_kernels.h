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

/// The bin of a place counted in bins from the first one; the last for NaN.
[[nodiscard]] constexpr std::uint32_t bin_at(float place, float last_bin) noexcept {
    return static_cast<std::uint32_t>(place < last_bin ? place : last_bin);
}

/// Which bin a PrimRef falls into on each axis, by the sum lower + upper of its box (twice its
/// centroid: halving it would change nothing). A scale of 0 puts all into bin 0.
struct BinMapping {
    std::array<float, 3> origin;
    std::array<float, 3> scale;
    std::uint32_t bin_count;

    /// The bin of a PrimRef on an axis.
    [[nodiscard]] std::uint32_t bin_of(const PrimRef& prim_ref, std::size_t axis) const noexcept {
        const float sum = prim_ref.upper[axis] - prim_ref.negated_lower[axis];
        return bin_at((sum - origin[axis]) * scale[axis], static_cast<float>(bin_count - 1));
    }

    /// The place where bin `bin` begins on an axis.
    [[nodiscard]] float begin_of(std::size_t axis, std::uint32_t bin) const noexcept {
        return origin[axis] + static_cast<float>(bin) / scale[axis];
    }
};

/// The boxes and summed weights of the PrimRefs in each bin.
struct alignas(32) Bins {
    std::array<std::array<Box8, max_bin_count>, 3> box;
    std::array<std::array<float, max_bin_count>, 3> weight;
};

/// How many primitives a leaf's cost counts in one: 8 where a block of 8 costs as much as one.
struct SplitCosts {
    float block_size;     ///< weights are divided by it
    bool whole_blocks;    ///< and rounded up
    float extent_factor;  ///< on edge lengths before areas are taken: keeps them finite
};

/// A split of PrimRefs into those below bin `bin` on an axis and the others.
struct ObjectSplit {
    float cost = std::numeric_limits<float>::infinity();  ///< area times blocks, both sides
    std::uint32_t axis = 0;
    std::uint32_t bin = 0;  ///< 0: there is no split
    float lower_weight = 0.0F;
    Box8 lower_box;
    Box8 upper_box;
};

/// A border between bins.
struct Border {
    const BinMapping& mapping;
    std::uint32_t axis;
    std::uint32_t bin;  ///< the first above it
};

/// Something for each side of a border.
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

/// What the lanes without a triangle hold: no ray hits it.
inline constexpr Vec3f nowhere{std::numeric_limits<float>::quiet_NaN(),
                               std::numeric_limits<float>::quiet_NaN(),
                               std::numeric_limits<float>::quiet_NaN()};

inline constexpr Box8 empty_box = Box8::make_empty();

/// The inner loops of the 8-wide builder, compiled for one instruction set. All sets give the same
/// results to the bit.
struct Kernels {
    /// The box of PrimRefs and the range of their centroids.
    void (*unite)(std::span<const PrimRef>, Box8& box, Box8& centroids) noexcept;

    /// Adds PrimRefs to bins.
    void (*bin)(std::span<const PrimRef>, const BinMapping&, Bins&) noexcept;

    /// The cheapest split between bins; bin 0 if all PrimRefs are in one bin.
    ObjectSplit (*find_split)(const Bins&, std::uint32_t bin_count, const SplitCosts&) noexcept;

    /// Copies PrimRefs to the two sides of a border, in their order, and finds both ranges of
    /// centroids.
    void (*partition)(std::span<const PrimRef>, const Border&, Sides<PrimRef*> out,
                      Sides<Box8>& centroids) noexcept;

    /// Cuts one triangle in `stride` at the borders of slabs and adds the pieces to those of each
    /// axis.
    void (*bin_pieces)(std::span<const PrimRef>, std::size_t stride, const MeshArrays&,
                       const Slabs&, std::array<SlabContents, 3>&) noexcept;

    /// How many PrimRefs have a piece on each side of a plane.
    Sides<std::uint32_t> (*count_pieces)(std::span<const PrimRef>, const MeshArrays&,
                                         CutPlane) noexcept;

    /// Copies PrimRefs to the two sides of a plane, in their order, each with the box of its
    /// piece there.
    void (*write_pieces)(std::span<const PrimRef>, const MeshArrays&, CutPlane, Sides<PrimRef*> out,
                         Sides<Measure>&) noexcept;

    /// Copies the corners of up to eight triangles into a block.
    void (*fill_block)(std::span<const std::uint32_t> ids, const MeshArrays&,
                       TriangleBlock&) noexcept;
};

/// The kernels for an instruction set that this processor has.
[[nodiscard]] const Kernels& kernels_for(Isa isa) noexcept;

/// Empties the first `bin_count` bins.
void clear(Bins& bins, std::uint32_t bin_count) noexcept;

}  // namespace coppice::inline v0::bvh8
