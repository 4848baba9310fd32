// Lower bounds of squared distances, eight at a time: from a point to the boxes of a node's
// children and to the triangles of a block. Included once for each instruction set, before
// mesh_search.inl. Loops over the eight lanes are written so that compilers make vector code of
// them.
//
// Everything is scaled by a power of two to coordinates of about 1, so that squares neither
// overflow nor vanish. A bound is never more than the distance that closest_point() finds in
// double: all that rounding can do, here and there, is taken off it or, where it is relative, put
// onto the limit that bounds are compared with.

using LaneFloats = std::array<float, bvh8_width>;

// By value, unlike those of std: loops over lanes need that.
inline float smaller(float a, float b) noexcept {
    return a < b ? a : b;
}

inline float larger(float a, float b) noexcept {
    return a > b ? a : b;
}

inline float sum_of_abs(Vec3f v) noexcept {
    return std::abs(v.x) + (std::abs(v.y) + std::abs(v.z));
}

// Bit i is set if lanes[i] <= limit.
inline unsigned mask_within(const LaneFloats& lanes, float limit) noexcept {
    unsigned mask = 0;
    for (unsigned lane = 0; lane < bvh8_width; ++lane) {
        mask |= (lanes[lane] <= limit ? 1U : 0U) << lane;
    }
    return mask;
}

// The point to search from, scaled with the scene to coordinates of about 1.
class ScaledPoint {
public:
    ScaledPoint(Vec3f point, const Aabb& bounds) noexcept
        : scale_(scale_for(point, bounds)), at_(scale_ * point) {}

    [[nodiscard]] float scale() const noexcept { return scale_; }

    [[nodiscard]] Vec3f at() const noexcept { return at_; }

    // A squared distance in these units, rounded up: by more than all that bounds are off.
    [[nodiscard]] float scaled_up(double distance_squared) const noexcept {
        constexpr double utmost = 0x1.0p30;  // farther than anything; empty slots are at infinity
        const double scaled = distance_squared * scale_ * scale_;
        return static_cast<float>(std::min(scaled, utmost)) * (1.0F + 0x1.0p-18F) + 0x1.0p-110F;
    }

private:
    static float scale_for(Vec3f point, const Aabb& bounds) noexcept {
        float largest = 0.0F;
        for (const Axis axis : all_axes) {
            largest = larger(largest, std::abs(point[axis]));
            largest = larger(largest, std::abs(bounds.lower[axis]));
            largest = larger(largest, std::abs(bounds.upper[axis]));
        }
        return std::ldexp(1.0F, -std::clamp(std::ilogb(largest), -126, 126));
    }

    float scale_;
    Vec3f at_;
};

// Lower bounds of the squared distances to the boxes of all children. Each may be off by the
// rounding of a few operations in float; closest_point() may be off by that of doubles, of which
// the subtrahend takes care. Empty slots are at infinity.
inline void bound_boxes(const Bvh8Node& node, const ScaledPoint& point,
                        LaneFloats& bounds) noexcept {
    constexpr float rounding = 0x1.0p-44F;
    const float scale = point.scale();
    const auto outside = [&](float lower, float upper, float at) {
        const float gap = larger(lower * scale - at, at - upper * scale) - rounding;
        return gap > 0.0F ? gap : 0.0F;
    };
    for (std::size_t lane = 0; lane < bvh8_width; ++lane) {
        const float x = outside(node.bound[0][lane], node.bound[3][lane], point.at().x);
        const float y = outside(node.bound[1][lane], node.bound[4][lane], point.at().y);
        const float z = outside(node.bound[2][lane], node.bound[5][lane], point.at().z);
        bounds[lane] = x * x + (y * y + z * z);
    }
}

// The point of an edge closest to the origin.
inline Vec3f closest_on_edge(Vec3f from, Vec3f to) noexcept {
    const Vec3f along = to - from;
    const float length_squared = dot(along, along);
    const float share = -dot(from, along) / (length_squared > 0.0F ? length_squared : 1.0F);
    return from + smaller(larger(share, 0.0F), 1.0F) * along;
}

// A lower bound of the squared distance of a triangle from the origin: how far it is along a
// direction. Any direction will do, that of its closest point is best. `rounding` is more than
// what rounding does to a distance along a direction of length 1.
inline float bound_along(Vec3f direction, Vec3f a, Vec3f b, Vec3f c, float rounding) noexcept {
    const float size = sum_of_abs(direction);
    const Vec3f unit = (size > 0x1.0p-100F ? 1.0F / size : 0.0F) * direction;
    const float to_a = dot(unit, a);
    const float to_b = dot(unit, b);
    const float to_c = dot(unit, c);
    const float least = smaller(to_a, smaller(to_b, to_c));
    const float most = larger(to_a, larger(to_b, to_c));
    const float gap = larger(least, -most) - rounding;
    const float length_squared = dot(unit, unit);
    return gap > 0.0F ? gap * gap / length_squared : 0.0F;
}

inline float length_squared(Vec3f v) noexcept {
    return dot(v, v);
}

inline Vec3f shorter(Vec3f a, Vec3f b) noexcept {
    const bool is_first = length_squared(a) < length_squared(b);
    return {is_first ? a.x : b.x, is_first ? a.y : b.y, is_first ? a.z : b.z};
}

// Lower bounds of the squared distances to the triangles of a block: along the direction of the
// closest point of their edges, and along their normal if that is more. Lanes without a triangle
// have any.
inline void bound_triangles(const TriangleBlock& block, const ScaledPoint& point,
                            LaneFloats& bounds) noexcept {
    const float scale = point.scale();
    const auto corner = [&](std::size_t at, std::size_t lane) {
        const auto& axes = block.corner[at];
        return Vec3f{axes[0][lane] * scale - point.at().x, axes[1][lane] * scale - point.at().y,
                     axes[2][lane] * scale - point.at().z};
    };
    for (std::size_t lane = 0; lane < bvh8_width; ++lane) {
        const Vec3f a = corner(0, lane);
        const Vec3f b = corner(1, lane);
        const Vec3f c = corner(2, lane);
        const float rounding =
            0x1.0p-20F * (sum_of_abs(a) + sum_of_abs(b) + sum_of_abs(c)) + 0x1.0p-44F;
        const Vec3f closest =
            shorter(closest_on_edge(a, b), shorter(closest_on_edge(b, c), closest_on_edge(c, a)));
        bounds[lane] = larger(bound_along(closest, a, b, c, rounding),
                              bound_along(cross(b - a, c - a), a, b, c, rounding));
    }
}
