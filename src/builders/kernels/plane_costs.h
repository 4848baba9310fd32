#pragma once

#include <cstddef>

namespace coppice::inline v0 {

inline constexpr std::size_t small_node_capacity = 64;

/// The ends of a small node's PrimRefs on one axis, and their weights. No end is -0. Arrays are
/// padded to whole vectors of eight.
struct AxisEnds {
    const float* lower;   ///< infinite from `count` on
    const float* upper;   ///< minus infinite from `count` on
    const float* weight;  ///< 0 from `count` on
    std::size_t count;    ///< at most small_node_capacity
    bool has_planar;      ///< true if a PrimRef is flat on the axis
    bool are_weights_one;
};

/// The terms that the cost of a plane depends on besides the counts; see PlaneEvaluator.
struct CostTerms {
    double lower;  ///< bounds of the node on the axis
    double upper;
    double cap_area;        ///< area of both faces perpendicular to the axis
    double side_perimeter;  ///< area of the other four faces per unit of length
    double inverse_area;
    double traversal;
    double intersection;
    double empty_intersection;  ///< intersection cost if a side is empty
};

/// The cheapest plane on an axis, the first of equal ones. PrimRefs in the plane are on the cheaper
/// side. The cost is infinite if there is no plane.
struct BestPlane {
    double cost;
    float position;
};

}  // namespace coppice::inline v0
