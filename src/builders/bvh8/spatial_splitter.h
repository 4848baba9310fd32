#pragma once

#include "coppice/geom/triangle_mesh.h"

#include "builders/bvh8/splitter.h"

#include <array>
#include <limits>
#include <optional>
#include <span>

namespace coppice::inline v0::bvh8 {

/// Splits ranges of PrimRefs at planes, where that is cheaper than to divide them: a triangle
/// that the plane cuts is then on both sides, with the box of the part that it has there. Ranges
/// must have room for the PrimRefs that this adds. The same result for any number of threads.
/// Source: [Stich2009] sec. 4.
class SpatialSplitter {
public:
    /// For PrimRefs to a mesh's triangles in two buffers as long as each other. `bounds` is the
    /// box of all of them.
    SpatialSplitter(std::span<PrimRef> first, std::span<PrimRef> second, TriangleMeshView mesh,
                    const Box8& bounds, const Kernels& kernels) noexcept;

    /// The halves of a range on the sides of a plane, if that is cheaper than `split` and there is
    /// room for it.
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
    float factor_;         // on edges, before areas are taken
    float least_overlap_;  // of an object split's halves, in such an area
    bool can_calculate_;   // no edge of the scene is so long that sums would overflow
    const Kernels& kernels_;
};

}  // namespace coppice::inline v0::bvh8
