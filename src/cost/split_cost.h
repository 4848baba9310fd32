// The surface area heuristic for any type of number: a double, or lanes of numbers. All code that
// evaluates splits uses this formula. For lanes, it must be compiled for their instruction set
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

// The primitive counts of both sides, each weighted by the relative area of its side, summed.
template <typename Number>
COPPICE_LANES Number weighted_areas(const Number& area_below, const Number& count_below,
                                    const Number& area_above, const Number& count_above) noexcept {
    return area_below * count_below + area_above * count_above;
}

// SahCostModel::split_cost(), with `intersection` already reduced where a side is empty.
template <typename Number>
COPPICE_LANES Number split_cost(const Number& traversal, const Number& intersection,
                                const Number& p_below, const Number& count_below,
                                const Number& p_above, const Number& count_above) noexcept {
    return traversal + intersection * weighted_areas(p_below, count_below, p_above, count_above);
}

// The surface area of a part of a node, divided by the node's: both caps across an axis, plus the
// perimeter of a cap times the part's length on that axis.
template <typename Number>
COPPICE_LANES Number area_share(const Number& cap_area, const Number& perimeter,
                                const Number& length, const Number& inverse_area) noexcept {
    return (cap_area + perimeter * length) * inverse_area;
}

}  // namespace coppice::inline v0::sah::COPPICE_SIMD_SET

COPPICE_SIMD_END

#endif
