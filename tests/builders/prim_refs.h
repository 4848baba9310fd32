// Random PrimRefs for tests of splitting.
#pragma once

#include "coppice/builders/split_finder.h"

#include "support/random.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace coppice::test {

/// How PrimRefs lie in their node, the unit cube.
enum class Layout { random, grid, planar, points, identical };

inline constexpr Aabb unit_cube{{0, 0, 0}, {1, 1, 1}};

/// PrimRefs within the unit cube, ids ascending.
[[nodiscard]] inline std::vector<PrimRef> make_prim_refs(Layout layout, std::uint32_t count,
                                                         Random& random) {
    std::vector<PrimRef> prim_refs;
    const Vec3f shared = random.in_box(unit_cube);
    for (std::uint32_t id = 0; id < count; ++id) {
        Aabb box;
        for (int corner = 0; corner < 2; ++corner) {
            Vec3f p = random.in_box(unit_cube);
            if (layout == Layout::grid) {
                for (const Axis axis : all_axes) {
                    p[axis] = 0.25F * static_cast<float>(random.below(5));
                }
            }
            if (layout == Layout::identical) p = corner == 0 ? shared : 0.5F * shared;
            if (layout != Layout::points || corner == 0) box.grow(p);
        }
        if (layout == Layout::planar && id % 2 == 0) {
            const auto axis = static_cast<Axis>(random.below(3));
            box.lower[axis] = box.upper[axis] = 0.125F * static_cast<float>(random.below(9));
        }
        prim_refs.push_back({box, id});
    }
    return prim_refs;
}

/// What a plane would cost, written apart from the library: METHOD 1.3, with the boxes' own areas.
[[nodiscard]] inline double naive_split_cost(const std::vector<PrimRef>& prim_refs, const Aabb& box,
                                             const SahCostModel& model, SplitPlane plane,
                                             PlanarSide side) {
    double below_count = 0.0;
    double above_count = 0.0;
    for (const PrimRef& prim_ref : prim_refs) {
        const float lower = prim_ref.box.lower[plane.axis];
        const float upper = prim_ref.box.upper[plane.axis];
        const bool is_in_plane = lower == plane.position && upper == plane.position;
        const bool is_below = is_in_plane ? side == PlanarSide::below : lower < plane.position;
        const bool is_above = is_in_plane ? side == PlanarSide::above : upper > plane.position;
        below_count += is_below ? 1.0 : 0.0;
        above_count += is_above ? 1.0 : 0.0;
    }
    const double bonus = below_count == 0.0 || above_count == 0.0 ? model.empty_bonus : 0.0;
    const double area = box.surface_area();
    return model.traversal + model.intersection * (1.0 - bonus) *
                                 (below(box, plane).surface_area() / area * below_count +
                                  above(box, plane).surface_area() / area * above_count);
}

/// naive_split_cost() with planar PrimRefs on their better side.
[[nodiscard]] inline double naive_plane_cost(const std::vector<PrimRef>& prim_refs, const Aabb& box,
                                             const SahCostModel& model, SplitPlane plane) {
    return std::min(naive_split_cost(prim_refs, box, model, plane, PlanarSide::below),
                    naive_split_cost(prim_refs, box, model, plane, PlanarSide::above));
}

}  // namespace coppice::test
