#pragma once

#include "coppice/export.h"
#include "coppice/geom/aabb.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// A view of an array of points. Does not own the array, which must outlive the view. Satisfies
/// PrimitiveSet: primitive i is point i.
class COPPICE_EXPORT PointCloudView {
public:
    PointCloudView() = default;

    /// A view of `points`. Throws Error(limit) for 2^32 points or more, since ids have 32 bits.
    explicit PointCloudView(std::span<const Vec3f> points);

    /// The points of the cloud.
    [[nodiscard]] std::span<const Vec3f> points() const noexcept { return points_; }

    /// Number of points.
    [[nodiscard]] std::uint32_t size() const noexcept {
        return static_cast<std::uint32_t>(points_.size());
    }

    /// The box of point `id`, whose corners are both the point itself; id < size().
    [[nodiscard]] Aabb bounds(std::uint32_t id) const noexcept {
        return {points_[id], points_[id]};
    }

    /// bounds(id) if the point lies in `box`, otherwise the empty box.
    [[nodiscard]] Aabb clipped_bounds(std::uint32_t id, const Aabb& box) const noexcept {
        return box.contains(points_[id]) ? bounds(id) : Aabb{};
    }

private:
    std::span<const Vec3f> points_;
};

/// The distinct positions among `points`, in a random order that depends on `seed` alone. The
/// thesis builds its trees on such a list. -0 and +0 are the same position. At most 2^32 - 1
/// points; none may be NaN.
/// Source: [Tsiompikas2022] sec. 4.2.
[[nodiscard]] COPPICE_EXPORT std::vector<Vec3f> shuffled_distinct_points(
    std::span<const Vec3f> points, std::uint64_t seed);

}  // namespace coppice::inline v0
