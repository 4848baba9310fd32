// Boxes and PrimRefs of the 8-wide builder in eight lanes: the negated lower corner, then the upper
// corner, so that one maximum unites two boxes.

#include "simd/set.h"

#if defined(COPPICE_BUILDERS_KERNELS_BOXES_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_BUILDERS_KERNELS_BOXES_H
#else
#define COPPICE_BUILDERS_KERNELS_BOXES_H
#endif

#include "coppice/geom/vec3.h"

#include "builders/bvh8/prim_ref.h"
#include "builders/kernels/bvh8_kernels.h"

#include <array>
#include <cstdint>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0::bvh8 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

inline Lanes load_box(const Box8& box) noexcept {
    return load_unaligned(box.lane.data());
}

inline void store_box(Lanes lanes, Box8& box) noexcept {
    store_unaligned(lanes, box.lane.data());
}

inline Lanes lanes_of(const PrimRef& prim_ref) noexcept {
    return load_unaligned(prim_ref.negated_lower.data());
}

// The box of a single point.
inline Lanes lanes_of(const Vec3f& point) noexcept {
    const Quad coordinates = load_point(&point.x);
    return join(-coordinates, coordinates);
}

inline void grow(Box8& box, Lanes piece) noexcept {
    store_box(max(piece, load_box(box)), box);
}

// True if the box is not empty: no axis has inverted bounds.
inline bool has_extent(Lanes box) noexcept {
    constexpr unsigned all_axes_bits = 0b111;
    const Quad extent = lower_half(box) + upper_half(box);
    const unsigned axes = greater_equal(extent, make_quad(0.0F, 0.0F, 0.0F, 0.0F));
    return (axes & all_axes_bits) == all_axes_bits;
}

// The sums lower + upper of a box on each axis.
inline Quad sum_of(Lanes box) noexcept {
    return upper_half(box) - lower_half(box);
}

// The sums lower + upper of a box, as the box of a single point.
inline Lanes centroid_of(Lanes box) noexcept {
    const Quad sum = sum_of(box);
    return join(-sum, sum);
}

// Half the surface area of a box, with edges multiplied by `factor`.
inline float half_area(Lanes box, float factor) noexcept {
    const Quad extent =
        (upper_half(box) + lower_half(box)) * make_quad(factor, factor, factor, factor);
    return sum_of_axes(extent * of_next_axis(extent));
}

// Applies a BinMapping on all axes at once.
class Binner {
public:
    explicit Binner(const BinMapping& mapping) noexcept
        : origin_(make_quad(mapping.origin[0], mapping.origin[1], mapping.origin[2], 0.0F)),
          scale_(make_quad(mapping.scale[0], mapping.scale[1], mapping.scale[2], 0.0F)) {
        const auto last = static_cast<float>(mapping.bin_count - 1);
        last_ = make_quad(last, last, last, last);
    }

    [[nodiscard]] std::array<std::uint32_t, 3> operator()(Lanes prim_ref) const noexcept {
        const Quad place = (sum_of(prim_ref) - origin_) * scale_;
        return to_integers(min(place, last_));  // NaN becomes the last bin
    }

private:
    Quad origin_;
    Quad scale_;
    Quad last_;
};

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0::bvh8

COPPICE_SIMD_END

#endif
