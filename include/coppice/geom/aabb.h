#pragma once

#include "coppice/geom/vec3.h"

#include <algorithm>
#include <limits>

namespace coppice::inline v0 {

/// A plane perpendicular to an axis.
struct SplitPlane {
    Axis axis = Axis::x;    ///< the axis that is perpendicular to the plane
    float position = 0.0F;  ///< coordinate on that axis

    friend constexpr bool operator==(const SplitPlane&, const SplitPlane&) = default;
};

/// An axis-aligned box, closed on all sides. The empty box is lower = +inf, upper = -inf.
struct Aabb {
    /// The infinity of float.
    static constexpr float infinity = std::numeric_limits<float>::infinity();

    Vec3f lower{infinity, infinity, infinity};     ///< the least coordinates
    Vec3f upper{-infinity, -infinity, -infinity};  ///< the greatest

    /// True if the box contains no point: its bounds are inverted or NaN.
    [[nodiscard]] constexpr bool is_empty() const noexcept {
        return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z);
    }

    /// True if no bound is NaN or infinite.
    [[nodiscard]] bool is_finite() const noexcept {
        return coppice::is_finite(lower) && coppice::is_finite(upper);
    }

    /// Edge length along an axis, in double so that no finite box overflows; 0 if empty.
    [[nodiscard]] constexpr double extent(Axis axis) const noexcept {
        return std::max(0.0, static_cast<double>(upper[axis]) - static_cast<double>(lower[axis]));
    }

    /// The axis of the longest edge; the first such axis if several are equally long.
    [[nodiscard]] constexpr Axis longest_axis() const noexcept {
        Axis longest = Axis::x;
        for (const Axis axis : {Axis::y, Axis::z}) {
            if (extent(axis) > extent(longest)) longest = axis;
        }
        return longest;
    }

    /// Area of the six faces, in double (a 1e30 box does not overflow); 0 if empty.
    [[nodiscard]] constexpr double surface_area() const noexcept {
        const double dx = extent(Axis::x);
        const double dy = extent(Axis::y);
        const double dz = extent(Axis::z);
        return 2.0 * (dx * dy + dy * dz + dz * dx);
    }

    /// True if the point lies in the box or on its faces.
    [[nodiscard]] constexpr bool contains(Vec3f p) const noexcept {
        return lower.x <= p.x && p.x <= upper.x && lower.y <= p.y && p.y <= upper.y &&
               lower.z <= p.z && p.z <= upper.z;
    }

    /// True if the closed boxes have at least one point in common.
    [[nodiscard]] constexpr bool overlaps(const Aabb& other) const noexcept {
        return lower.x <= other.upper.x && other.lower.x <= upper.x && lower.y <= other.upper.y &&
               other.lower.y <= upper.y && lower.z <= other.upper.z && other.lower.z <= upper.z;
    }

    /// Extends the box so that it contains `p`.
    constexpr void grow(Vec3f p) noexcept {
        for (const Axis axis : all_axes) {
            lower[axis] = std::min(lower[axis], p[axis]);
            upper[axis] = std::max(upper[axis], p[axis]);
        }
    }

    /// Extends the box so that it contains `other`.
    constexpr void grow(const Aabb& other) noexcept {
        for (const Axis axis : all_axes) {
            lower[axis] = std::min(lower[axis], other.lower[axis]);
            upper[axis] = std::max(upper[axis], other.upper[axis]);
        }
    }

    friend constexpr bool operator==(const Aabb&, const Aabb&) = default;
};

/// The part of the box on the lower side of a plane that cuts it.
[[nodiscard]] constexpr Aabb below(Aabb box, SplitPlane plane) noexcept {
    box.upper[plane.axis] = plane.position;
    return box;
}

/// The part of the box on the upper side of a plane that cuts it.
[[nodiscard]] constexpr Aabb above(Aabb box, SplitPlane plane) noexcept {
    box.lower[plane.axis] = plane.position;
    return box;
}

/// The intersection of two boxes; empty if they do not overlap.
[[nodiscard]] constexpr Aabb intersection(const Aabb& a, const Aabb& b) noexcept {
    Aabb common;
    for (const Axis axis : all_axes) {
        common.lower[axis] = std::max(a.lower[axis], b.lower[axis]);
        common.upper[axis] = std::min(a.upper[axis], b.upper[axis]);
    }
    return common;
}

}  // namespace coppice::inline v0
