#pragma once

#include <cstddef>

namespace coppice {

inline constexpr std::size_t small_node_capacity = 64;

/// The ends of a small node's fragments on one axis, and their weights.
struct AxisEnds {
    const float* lower;
    const float* upper;
    const float* weight;
    std::size_t count;  ///< at most small_node_capacity
    bool has_planar;    ///< one of the fragments is flat
};

/// Candidate planes on one axis: each a position, the weights that reach below, above and only into
/// it, and what a split there costs with those in the plane on the better side. Whole vectors are
/// written: what stands from `count` on is arbitrary.
struct AxisPlanes {
    static constexpr std::size_t capacity = 2 * small_node_capacity;

    alignas(32) float position[capacity + 1];
    alignas(32) float below[capacity];
    alignas(32) float above[capacity];
    alignas(32) float in_plane[capacity];
    alignas(32) double cost[capacity];
    std::size_t count = 0;
};

/// What the cost of a plane depends on beside the counts; see PlaneEvaluator.
struct CostTerms {
    double lower;  ///< the node on the axis
    double upper;
    double cap_area;        ///< of both faces perpendicular to the axis
    double side_perimeter;  ///< area of the other four faces per unit of length
    double inverse_area;
    double traversal;
    double intersection;
    double empty_intersection;  ///< where a side is empty
};

/// Fills in counts and costs of the planes at their positions and returns the least cost. Costs
/// are, bit for bit, those of PlaneEvaluator.
double find_plane_costs(const AxisEnds& ends, const CostTerms& terms, AxisPlanes& planes) noexcept;

}  // namespace coppice
