// Counts fragments on both sides of all planes of a small node, and evaluates the heuristic there:
// each fragment is compared with a vector of planes at a time, without a branch and without
// sorting. Cost: O(fragments planes / 8), less than a sort up to some 64 fragments, where most
// nodes of a k-d tree are.
//
// No fused multiply-add may be used here: costs must equal those of the scalar code.

#include "build/kernels/plane_costs.h"

#include <cstdint>
#include <cstring>

// The function is compiled for either instruction set and chosen when the program is loaded.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__)
#define COPPICE_PLANE_COSTS_TARGETS __attribute__((target_clones("avx2", "default")))
#else
#define COPPICE_PLANE_COSTS_TARGETS
#endif

namespace coppice {
namespace {

constexpr std::size_t lane_count = 8;

using Floats = float __attribute__((vector_size(4 * lane_count)));
using Masks = std::int32_t __attribute__((vector_size(4 * lane_count)));

// Adds `weight` where the mask is set.
inline void add_where(const Masks& mask, float weight, Floats& sum) noexcept {
    const Floats all = weight - Floats{};
    sum += reinterpret_cast<Floats>(reinterpret_cast<Masks>(all) & mask);
}

inline void count_sides(const AxisEnds& ends, AxisPlanes& planes) noexcept {
    for (std::size_t plane = 0; plane < planes.count; plane += lane_count) {
        Floats position;
        std::memcpy(&position, planes.position + plane, sizeof position);
        Floats below{};
        Floats above{};
        for (std::size_t i = 0; i < ends.count; ++i) {
            add_where(ends.lower[i] < position, ends.weight[i], below);
            add_where(ends.upper[i] > position, ends.weight[i], above);
        }
        std::memcpy(planes.below + plane, &below, sizeof below);
        std::memcpy(planes.above + plane, &above, sizeof above);
    }
}

inline void count_in_plane(const AxisEnds& ends, AxisPlanes& planes) noexcept {
    for (std::size_t plane = 0; plane < planes.count; plane += lane_count) {
        Floats position;
        std::memcpy(&position, planes.position + plane, sizeof position);
        Floats in_plane{};
        for (std::size_t i = 0; i < ends.count; ++i) {
            add_where((ends.lower[i] == position) & (ends.upper[i] == position), ends.weight[i],
                      in_plane);
        }
        std::memcpy(planes.in_plane + plane, &in_plane, sizeof in_plane);
    }
}

// The compiler makes vectors of this by itself.
inline double cost_of(const CostTerms& terms, double at, double below, double above) noexcept {
    const double p_below =
        (terms.cap_area + terms.side_perimeter * (at - terms.lower)) * terms.inverse_area;
    const double p_above =
        (terms.cap_area + terms.side_perimeter * (terms.upper - at)) * terms.inverse_area;
    const double intersection =
        below * above == 0.0 ? terms.empty_intersection : terms.intersection;
    return terms.traversal + intersection * (p_below * below + p_above * above);
}

inline double least_cost(const AxisPlanes& planes) noexcept {
    double least = planes.cost[0];
    for (std::size_t i = 1; i < planes.count; ++i) {
        least = planes.cost[i] < least ? planes.cost[i] : least;
    }
    return least;
}

}  // namespace

COPPICE_PLANE_COSTS_TARGETS
double find_plane_costs(const AxisEnds& ends, const CostTerms& terms, AxisPlanes& planes) noexcept {
    const CostTerms own_terms = terms;
    count_sides(ends, planes);
    if (!ends.has_planar) {
        for (std::size_t i = 0; i < planes.count; ++i) {
            planes.cost[i] =
                cost_of(own_terms, planes.position[i], planes.below[i], planes.above[i]);
            planes.in_plane[i] = 0.0F;
        }
        return least_cost(planes);
    }
    count_in_plane(ends, planes);
    for (std::size_t i = 0; i < planes.count; ++i) {
        const double at = planes.position[i];
        const double below = planes.below[i];
        const double above = planes.above[i];
        const double in_plane = planes.in_plane[i];
        const double cost_if_below = cost_of(own_terms, at, below + in_plane, above);
        const double cost_if_above = cost_of(own_terms, at, below, above + in_plane);
        planes.cost[i] = cost_if_above < cost_if_below ? cost_if_above : cost_if_below;
    }
    return least_cost(planes);
}

}  // namespace coppice
