// Small nodes are searched exactly without sorting: all ends strictly inside the node are candidate
// planes, and a vector kernel counts what lies on either side of each.
// Cost: O(n^2 / 8) for n fragments, on each axis.

#include "build/split/small_node.h"

#include "build/kernels/plane_costs.h"
#include "build/split/best_split.h"
#include "build/split/evaluate_plane.h"

#include <array>

namespace coppice {
namespace {

// The fragments of a node, each number in an array of its own.
class NodeEnds {
public:
    explicit NodeEnds(std::span<const Fragment> fragments) noexcept : count_(fragments.size()) {
        std::array<bool, 3> has_planar{};
        for (std::size_t i = 0; i < count_; ++i) {
            const Fragment& fragment = fragments[i];
            const Vec3f& lower = fragment.box.lower;
            const Vec3f& upper = fragment.box.upper;
            lower_[0][i] = lower.x;
            lower_[1][i] = lower.y;
            lower_[2][i] = lower.z;
            upper_[0][i] = upper.x;
            upper_[1][i] = upper.y;
            upper_[2][i] = upper.z;
            weight_[i] = fragment.weight;
            has_planar[0] |= lower.x == upper.x;
            has_planar[1] |= lower.y == upper.y;
            has_planar[2] |= lower.z == upper.z;
        }
        has_planar_ = has_planar;
    }

    [[nodiscard]] AxisEnds on(Axis axis) const noexcept {
        const auto index = static_cast<std::size_t>(axis);
        return {lower_[index].data(), upper_[index].data(), weight_.data(), count_,
                has_planar_[index]};
    }

private:
    using Numbers = std::array<float, small_node_capacity>;

    std::array<Numbers, 3> lower_;
    std::array<Numbers, 3> upper_;
    Numbers weight_;
    std::array<bool, 3> has_planar_;
    std::size_t count_;
};

void list_planes(const AxisEnds& ends, const PlaneEvaluator& evaluator,
                 AxisPlanes& planes) noexcept {
    std::size_t count = 0;
    const auto list = [&](float position) {
        planes.position[count] = position + 0.0F;  // never -0: of equal planes either may be chosen
        count += evaluator.is_inside(position) ? 1U : 0U;
    };
    for (std::size_t i = 0; i < ends.count; ++i) {
        list(ends.lower[i]);
    }
    for (std::size_t i = 0; i < ends.count; ++i) {
        list(ends.upper[i]);
    }
    planes.count = count;
}

void search_axis(const AxisEnds& ends, const PlaneEvaluator& evaluator, BestSplit& best) noexcept {
    AxisPlanes planes;
    list_planes(ends, evaluator, planes);
    if (planes.count == 0) return;
    const double least = find_plane_costs(ends, evaluator.terms(), planes);
    if (least > best.cost()) return;
    for (std::size_t i = 0; i < planes.count; ++i) {
        if (planes.cost[i] != least) continue;
        best.offer(evaluator.evaluate(planes.position[i],
                                      {planes.below[i], planes.above[i], planes.in_plane[i]}));
    }
}

}  // namespace

std::optional<Split> find_in_small_node(const SplitQuery& query) noexcept {
    const NodeEnds ends(query.fragments);
    const double inverse_area = 1.0 / query.box.surface_area();
    BestSplit best;
    for (const Axis axis : all_axes) {
        search_axis(ends.on(axis), PlaneEvaluator(query.box, axis, query.cost, inverse_area), best);
    }
    return best.get();
}

}  // namespace coppice
