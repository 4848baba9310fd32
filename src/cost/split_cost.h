// The surface area heuristic for any kind of number, a double or lanes of numbers: one formula for
// all that evaluates splits. For lanes it has to be compiled for their instruction set
// (simd/set.h).

#include "simd/set.h"

#if defined(COPPICE_COST_SPLIT_COST_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_COST_SPLIT_COST_H
#else
#define COPPICE_COST_SPLIT_COST_H
#endif

COPPICE_SIMD_BEGIN

namespace coppice::inline v0::sah::COPPICE_SIMD_SET {

// What the counts on both sides of a split add up to, each weighted by the area of its side.
template <typename Number>
COPPICE_LANES Number weighted_areas(const Number& area_below, const Number& count_below,
                                    const Number& area_above, const Number& count_above) noexcept {
    return area_below * count_below + area_above * count_above;
}

// SahCostModel::split_cost(); `intersection` is less where a side is empty.
template <typename Number>
COPPICE_LANES Number split_cost(const Number& traversal, const Number& intersection,
                                const Number& p_below, const Number& count_below,
                                const Number& p_above, const Number& count_above) noexcept {
    return traversal + intersection * weighted_areas(p_below, count_below, p_above, count_above);
}

// A part's surface area over that of its node: both caps across an axis, and the perimeter around
// them times the part's length on that axis.
template <typename Number>
COPPICE_LANES Number area_share(const Number& cap_area, const Number& perimeter,
                                const Number& length, const Number& inverse_area) noexcept {
    return (cap_area + perimeter * length) * inverse_area;
}

}  // namespace coppice::inline v0::sah::COPPICE_SIMD_SET

COPPICE_SIMD_END

#endif
