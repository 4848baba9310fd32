#pragma once

#include "coppice/base/cpu.h"
#include "coppice/geom/aabb.h"
#include "coppice/query/neighbor.h"
#include "coppice/query/visitor.h"
#include "coppice/tree/kd_tree.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace coppice::inline v0 {

/// The number of points that are tested at a time. Coordinate arrays must extend by this many
/// values beyond the last point.
inline constexpr std::size_t point_lanes = 8;

/// A k-d tree to search, with its points in the order of its references.
struct SearchedPoints {
    const KdTree& tree;
    const float* x;
    const float* y;
    const float* z;
};

/// The searches of a k-d tree over points for one instruction set. Preconditions: query points are
/// finite, boxes are not empty, and spans have room. `limit` is a squared distance.
struct PointSearchKernels {
    void (*nearest)(const SearchedPoints&, Vec3f point, double limit, Neighbor&) noexcept;
    std::size_t (*nearest_k)(const SearchedPoints&, Vec3f point, double limit,
                             std::span<Neighbor>) noexcept;
    void (*within)(const SearchedPoints&, Vec3f point, double limit, Visitor<Neighbor>) noexcept;
    void (*overlapping)(const SearchedPoints&, const Aabb&, Visitor<std::uint32_t>) noexcept;
};

/// The searches for an instruction set, which this processor must support.
[[nodiscard]] const PointSearchKernels& point_search_kernels_for(Isa isa) noexcept;

}  // namespace coppice::inline v0
