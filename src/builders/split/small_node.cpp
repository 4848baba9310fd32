// Searches small nodes exactly without sorting. All ends strictly inside the node are candidate
// planes, and a vector kernel counts the PrimRefs on both sides of each. Cost: O(n^2 / 8) for n
// PrimRefs, on each axis.

#include "builders/split/small_node.h"

#include "builders/kernels/kd_kernels.h"
#include "builders/split/axis_sweep.h"
#include "builders/split/evaluate_plane.h"

#include <array>
#include <limits>

namespace coppice::inline v0 {
namespace {

// The PrimRefs of a node as a structure of arrays.
class NodeEnds {
public:
    explicit NodeEnds(std::span<const PrimRef> prim_refs) noexcept : count_(prim_refs.size()) {
        std::array<bool, 3> has_planar{};
        float weight_sum = 0.0F;
        for (std::size_t i = 0; i < count_; ++i) {
            const PrimRef& prim_ref = prim_refs[i];
            const Vec3f& lower = prim_ref.box.lower;
            const Vec3f& upper = prim_ref.box.upper;
            lower_[0][i] = lower.x + 0.0F;  // -0 becomes +0
            lower_[1][i] = lower.y + 0.0F;
            lower_[2][i] = lower.z + 0.0F;
            upper_[0][i] = upper.x + 0.0F;
            upper_[1][i] = upper.y + 0.0F;
            upper_[2][i] = upper.z + 0.0F;
            weight_[i] = prim_ref.weight;
            has_planar[0] |= lower.x == upper.x;
            has_planar[1] |= lower.y == upper.y;
            has_planar[2] |= lower.z == upper.z;
            weight_sum += prim_ref.weight;
        }
        has_planar_ = has_planar;
        are_weights_one_ = weight_sum == static_cast<float>(count_);  // weights are at least 1
        pad();
    }

    [[nodiscard]] AxisEnds on(Axis axis) const noexcept {
        const auto index = static_cast<std::size_t>(axis);
        return {lower_[index].data(), upper_[index].data(), weight_.data(), count_,
                has_planar_[index],   are_weights_one_};
    }

private:
    using Numbers = std::array<float, small_node_capacity>;

    // Pads the arrays to whole vectors.
    void pad() noexcept {
        for (std::size_t i = count_; i % 8 != 0; ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                lower_[axis][i] = Aabb::infinity;
                upper_[axis][i] = -Aabb::infinity;
            }
            weight_[i] = 0.0F;
        }
    }

    std::array<Numbers, 3> lower_;
    std::array<Numbers, 3> upper_;
    Numbers weight_;
    std::array<bool, 3> has_planar_;
    bool are_weights_one_;
    std::size_t count_;
};

}  // namespace

std::optional<SplitCandidate> find_in_small_node(const SplitQuery& query) {
    if (query.cost.custom) return sweep_all_axes(query);  // the kernels have a fixed formula
    const NodeEnds ends(query.prim_refs);
    const KdKernels& kernels = kd_kernels_for(query.isa);
    const double inverse_area = 1.0 / query.box.surface_area();
    BestPlane best{std::numeric_limits<double>::infinity(), 0.0F};
    Axis best_axis = Axis::x;
    for (const Axis axis : all_axes) {
        const PlaneEvaluator evaluator(query.box, axis, query.cost, inverse_area);
        const BestPlane on_axis = kernels.find_best_plane(ends.on(axis), evaluator.terms());
        if (on_axis.cost < best.cost) {
            best = on_axis;
            best_axis = axis;
        }
    }
    if (best.cost == std::numeric_limits<double>::infinity()) return std::nullopt;
    const SplitPlane plane{best_axis, best.position};
    if (!ends.on(best_axis).has_planar) return SplitCandidate{plane, PlanarSide::below, best.cost};
    return evaluate_plane(query, plane);  // for the side of PrimRefs in the plane
}

}  // namespace coppice::inline v0
