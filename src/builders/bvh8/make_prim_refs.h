#pragma once

#include "coppice/geom/aabb.h"
#include "coppice/geom/triangle_mesh.h"

#include "builders/bvh8/prim_ref.h"

#include <cstdint>
#include <span>

namespace coppice::inline v0::bvh8 {

/// Makes a PrimRef of weight 1 for every triangle, in the order of their ids. Throws
/// Error(invalid_argument) naming the first triangle with a vertex index out of range, or else the
/// first whose box is not finite.
void make_prim_refs(TriangleMeshView mesh, std::span<PrimRef> prim_refs);

/// A PrimRef of weight 1 for primitive `id` with box `box`.
[[nodiscard]] inline PrimRef make_prim_ref(const Aabb& box, std::uint32_t id) noexcept {
    return {{-box.lower.x, -box.lower.y, -box.lower.z},
            id,
            {box.upper.x, box.upper.y, box.upper.z},
            1.0F};
}

/// A primitive set of PrimRefs, for samplers. Does not own the PrimRefs, which must outlive it.
class PrimRefSet {
public:
    explicit PrimRefSet(std::span<const PrimRef> prim_refs) noexcept : references_(prim_refs) {}

    [[nodiscard]] std::uint32_t size() const noexcept {
        return static_cast<std::uint32_t>(references_.size());
    }

    [[nodiscard]] Aabb bounds(std::uint32_t id) const noexcept {
        const auto& [lower, number, upper, weight] = references_[id];
        return {{-lower[0], -lower[1], -lower[2]}, {upper[0], upper[1], upper[2]}};
    }

    [[nodiscard]] Aabb clipped_bounds(std::uint32_t id, const Aabb& box) const noexcept {
        return intersection(bounds(id), box);
    }

private:
    std::span<const PrimRef> references_;
};

}  // namespace coppice::inline v0::bvh8
