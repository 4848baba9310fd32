#pragma once

#include "coppice/geom/triangle_mesh.h"

#include "builders/bvh8/splitter.h"

#include <array>
#include <limits>
#include <optional>
#include <span>

namespace coppice::inline v0::bvh8 {

/// Splits ranges of PrimRefs at planes, where that is cheaper than an object split. A triangle that
/// the plane cuts is then on both sides, each with the box of its part there. Ranges must have room
/// for the additional PrimRefs. The result does not depend on the number of threads.
/// Source: [Stich2009] sec. 4.
class SpatialSplitter {
public:
    /// Works on PrimRefs of the triangles of `mesh` in two buffers of equal length. `bounds` is the
    /// box of all of them.
    SpatialSplitter(std::span<PrimRef> first, std::span<PrimRef> second, TriangleMeshView mesh,
                    const Box8& bounds, const Kernels& kernels) noexcept;

    /// Splits a range at a plane if that is cheaper than `split` and there is room for it. Returns
    /// the halves, or nothing.
    [[nodiscard]] std::optional<Halves> improve(const Range& range, const ObjectSplit& split) const;

private:
    struct Cut {
        CutPlane plane{};
        float cost = std::numeric_limits<float>::infinity();  // in the unit of ObjectSplit::cost
    };

    [[nodiscard]] Cut find(const Range& range) const;
    [[nodiscard]] std::optional<Halves> divide(const Range& range, CutPlane plane) const;
    [[nodiscard]] std::span<const PrimRef> prim_refs(const Range& range) const noexcept;

    std::array<std::span<PrimRef>, 2> buffers_;
    MeshArrays mesh_;
    float factor_;         // scale of edges before areas are computed
    float least_overlap_;  // of an object split's halves, as a scaled area
    bool can_calculate_;   // false if sums would overflow for this scene
    const Kernels& kernels_;
};

}  // namespace coppice::inline v0::bvh8
