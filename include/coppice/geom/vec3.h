#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace coppice::inline v0 {

/// A coordinate axis; the values index the components of a vector.
enum class Axis : std::uint8_t { x = 0, y = 1, z = 2 };

inline constexpr std::array<Axis, 3> all_axes{Axis::x, Axis::y, Axis::z};  ///< x, y, z

/// The axis after this one, cyclically: x, y, z, x ...
[[nodiscard]] constexpr Axis next_axis(Axis axis) noexcept {
    return static_cast<Axis>((static_cast<unsigned>(axis) + 1) % 3);
}

/// A point or direction of three components, addressable by axis.
template <typename T>
struct Vec3 {
    T x{};  ///< component along the first axis
    T y{};  ///< component along the second axis
    T z{};  ///< component along the third axis

    /// The component along an axis.
    [[nodiscard]] constexpr T operator[](Axis axis) const noexcept {
        return axis == Axis::x ? x : axis == Axis::y ? y : z;
    }

    /// The component along an axis.
    [[nodiscard]] constexpr T& operator[](Axis axis) noexcept {
        return axis == Axis::x ? x : axis == Axis::y ? y : z;
    }

    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;

    /// The sum.
    friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

    /// The difference.
    friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

    /// The product with a scalar.
    friend constexpr Vec3 operator*(T s, Vec3 v) { return {s * v.x, s * v.y, s * v.z}; }
};

/// A vector of floats, the type of mesh vertices.
using Vec3f = Vec3<float>;
/// A vector of doubles.
using Vec3d = Vec3<double>;

/// The same vector in double precision.
[[nodiscard]] constexpr Vec3d to_double(Vec3f v) noexcept {
    return {v.x, v.y, v.z};
}

/// The nearest vector in single precision.
[[nodiscard]] constexpr Vec3f to_float(Vec3d v) noexcept {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// True if no coordinate is NaN or infinite.
[[nodiscard]] inline bool is_finite(Vec3f v) noexcept {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The scalar product.
template <typename T>
[[nodiscard]] constexpr T dot(Vec3<T> a, Vec3<T> b) noexcept {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The vector product, by the right-hand rule.
template <typename T>
[[nodiscard]] constexpr Vec3<T> cross(Vec3<T> a, Vec3<T> b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace coppice::inline v0
