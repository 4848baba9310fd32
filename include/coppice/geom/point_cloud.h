#pragma once

#include "coppice/export.h"
#include "coppice/geom/aabb.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// Points that are not owned and must outlive the view. Satisfies PrimitiveSet: primitive i is
/// point i.
class COPPICE_EXPORT PointCloudView {
public:
    PointCloudView() = default;

    /// Throws Error(limit) for 2^32 points or more: ids have 32 bits.
    explicit PointCloudView(std::span<const Vec3f> points);

    /// The points viewed.
    [[nodiscard]] std::span<const Vec3f> points() const noexcept { return points_; }

    /// Number of points.
    [[nodiscard]] std::uint32_t size() const noexcept {
        return static_cast<std::uint32_t>(points_.size());
    }

    /// The degenerate box of point `id`, id < size().
    [[nodiscard]] Aabb bounds(std::uint32_t id) const noexcept {
        return {points_[id], points_[id]};
    }

    /// bounds(id) if the point lies in `box`, else the empty box.
    [[nodiscard]] Aabb clipped_bounds(std::uint32_t id, const Aabb& box) const noexcept {
        return box.contains(points_[id]) ? bounds(id) : Aabb{};
    }

private:
    std::span<const Vec3f> points_;
};

/// The distinct positions among `points`, in a random order that depends on `seed` alone: the
/// thesis's primitives. -0 and +0 are the same position. At most 2^32 - 1 points; none may be NaN.
/// Source: [Tsiompikas2022] sec. 4.2.
[[nodiscard]] COPPICE_EXPORT std::vector<Vec3f> shuffled_distinct_points(
    std::span<const Vec3f> points, std::uint64_t seed);

}  // namespace coppice::inline v0
