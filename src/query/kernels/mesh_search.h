#pragma once

#include "coppice/base/cpu.h"
#include "coppice/geom/aabb.h"
#include "coppice/query/neighbor.h"
#include "coppice/query/visitor.h"
#include "coppice/tree/bvh8.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace coppice::inline v0 {

/// An 8-wide tree to search, with the set of triangles that are in several leaves.
struct SearchedMesh {
    const Bvh8& tree;
    std::span<const std::uint64_t> repeated;  ///< one bit per id; empty if there are none

    [[nodiscard]] bool is_repeated(std::uint32_t id) const noexcept {
        return !repeated.empty() && (repeated[id / 64] >> id % 64 & 1U) != 0;
    }
};

/// The searches of an 8-wide tree for one instruction set. Preconditions: points are finite, boxes
/// are not empty, and spans have room. `limit` is a squared distance.
struct MeshSearchKernels {
    void (*nearest)(const SearchedMesh&, Vec3f point, double limit, SurfaceNeighbor&) noexcept;
    std::size_t (*nearest_k)(const SearchedMesh&, Vec3f point, double limit,
                             std::span<SurfaceNeighbor>) noexcept;
    void (*within)(const SearchedMesh&, Vec3f point, double limit,
                   Visitor<SurfaceNeighbor>) noexcept;
    void (*overlapping)(const SearchedMesh&, const Aabb&, Visitor<std::uint32_t>) noexcept;
};

/// The searches for an instruction set, which this processor must support.
[[nodiscard]] const MeshSearchKernels& mesh_search_kernels_for(Isa isa) noexcept;

}  // namespace coppice::inline v0
