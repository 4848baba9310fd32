#pragma once

#include <cstddef>

namespace coppice::inline v0 {

inline constexpr std::size_t small_node_capacity = 64;

/// The ends of a small node's PrimRefs on one axis, and their weights; never -0. Arrays have whole
/// vectors of eight.
struct AxisEnds {
    const float* lower;   ///< infinite from `count` on
    const float* upper;   ///< minus infinite from `count` on
    const float* weight;  ///< 0 from `count` on
    std::size_t count;    ///< at most small_node_capacity
    bool has_planar;      ///< one of the PrimRefs is flat
    bool are_weights_one;
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

/// The plane on an axis at which a split costs least, the first of equal ones, with the PrimRefs
/// in it on the better side. The cost is infinite if there is none.
struct BestPlane {
    double cost;
    float position;
};

}  // namespace coppice::inline v0
