// Vectors of three coordinates in eight lanes.

#include "simd/set.h"

#if defined(COPPICE_SIMD_VECTORS_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_SIMD_VECTORS_H
#else
#define COPPICE_SIMD_VECTORS_H
#endif

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0::simd::COPPICE_SIMD_SET {

struct Lanes3 {
    Lanes x;
    Lanes y;
    Lanes z;
};

/// A vector of three floats x, y and z, repeated in all lanes.
template <typename Vector>
COPPICE_LANES Lanes3 broadcast3(const Vector& v) noexcept {
    return {broadcast(v.x), broadcast(v.y), broadcast(v.z)};
}

COPPICE_LANES Lanes3 operator+(const Lanes3& a, const Lanes3& b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

COPPICE_LANES Lanes3 operator-(const Lanes3& a, const Lanes3& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

COPPICE_LANES Lanes3 operator*(const Lanes& factor, const Lanes3& v) noexcept {
    return {factor * v.x, factor * v.y, factor * v.z};
}

COPPICE_LANES Lanes dot(const Lanes3& a, const Lanes3& b) noexcept {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

COPPICE_LANES Lanes length_squared(const Lanes3& v) noexcept {
    return dot(v, v);
}

COPPICE_LANES Lanes3 cross(const Lanes3& a, const Lanes3& b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace coppice::inline v0::simd::COPPICE_SIMD_SET

COPPICE_SIMD_END

#endif
