// Adaptive sampling of the cost. The cost is smooth except for the counts of PrimRefs on both
// sides. The counts are sampled at 8 evenly spaced planes an axis. 8 more planes are placed where,
// by linear interpolation, the difference of the counts passes evenly spaced values: many where it
// changes fast. The best of the 16 planes is chosen. Small nodes are searched exactly. The original
// minimizes a quadratic interpolant between planes; here the planes themselves are the candidates.
// Cost: O(n) a node.
// Source: [Hunt2006] sec. 3.

#include "builders/split/adaptive_split.h"

#include "coppice/base/parallel.h"

#include "builders/split/evaluate_plane.h"
#include "builders/split/small_node.h"

#include <algorithm>
#include <array>

namespace coppice::inline v0 {
namespace {

constexpr std::size_t plane_count = 8;

using Positions = std::array<float, plane_count>;     // ascending
using Counts = std::array<SplitCounts, plane_count>;  // at each position

Positions even_positions(const Aabb& box, Axis axis) noexcept {
    Positions positions;
    const double step = box.extent(axis) / static_cast<double>(plane_count + 1);
    for (std::size_t i = 0; i < plane_count; ++i) {
        positions[i] = static_cast<float>(box.lower[axis] + static_cast<double>(i + 1) * step);
    }
    return positions;
}

Counts count_at(const Positions& positions, std::span<const PrimRef> prim_refs,
                Axis axis) noexcept {
    std::array<double, plane_count + 1> starts{};  // indexed by the number of planes at or below
    std::array<double, plane_count + 1> ends{};    // indexed by the number of planes below
    for (const PrimRef& prim_ref : prim_refs) {
        unsigned before_start = 0;
        unsigned before_end = 0;
        for (const float position : positions) {
            before_start += position <= prim_ref.box.lower[axis] ? 1U : 0U;
            before_end += position < prim_ref.box.upper[axis] ? 1U : 0U;
        }
        starts[before_start] += prim_ref.weight;
        ends[before_end] += prim_ref.weight;
    }
    Counts counts{};
    for (std::size_t i = 0; i < plane_count; ++i) {
        counts[i].below = (i > 0 ? counts[i - 1].below : 0.0) + starts[i];
    }
    for (std::size_t i = plane_count; i-- > 0;) {
        counts[i].above = (i + 1 < plane_count ? counts[i + 1].above : 0.0) + ends[i + 1];
    }
    return counts;
}

// The positions where the difference of the counts passes evenly spaced values. It is -weight at
// the lower end of the box and weight at the upper end.
Positions adapted_positions(const Aabb& box, Axis axis, const Positions& even, const Counts& counts,
                            double weight) noexcept {
    Positions positions;
    std::size_t next = 0;  // next even position, or the box's upper end
    double at = box.lower[axis];
    double difference = -weight;
    for (std::size_t i = 0; i < plane_count; ++i) {
        const double target = weight * (2.0 * static_cast<double>(i + 1) / (plane_count + 1) - 1.0);
        for (;;) {
            const bool is_last = next == plane_count;
            const double next_at = is_last ? box.upper[axis] : even[next];
            const double next_difference =
                is_last ? weight : counts[next].below - counts[next].above;
            if (is_last || next_difference >= target) {
                const double rise = next_difference - difference;
                const double share = rise > 0.0 ? (target - difference) / rise : 0.0;
                positions[i] =
                    static_cast<float>(at + std::clamp(share, 0.0, 1.0) * (next_at - at));
                break;
            }
            at = next_at;
            difference = next_difference;
            ++next;
        }
    }
    return positions;
}

// The cheapest plane so far.
struct Best {
    std::optional<SplitPlane> plane;
    double cost = 0.0;

    void offer(const SplitQuery& query, Axis axis, const Positions& positions,
               const Counts& counts) noexcept {
        const PlaneEvaluator evaluator(query.box, axis, query.cost);
        for (std::size_t i = 0; i < plane_count; ++i) {
            if (!evaluator.is_inside(positions[i])) continue;
            const double at_cost = evaluator.evaluate(positions[i], counts[i]).cost;
            if (plane && at_cost >= cost) continue;
            plane = {axis, positions[i] + 0.0F};
            cost = at_cost;
        }
    }
};

}  // namespace

std::optional<SplitCandidate> AdaptiveSplit::find(const SplitQuery& query) const {
    if (query.prim_refs.size() <= small_node_size) return find_in_small_node(query);
    const double weight = weight_of(query.prim_refs);
    Best best;
    for (const Axis axis : all_axes) {
        throw_if_cancelled();
        const Positions even = even_positions(query.box, axis);
        const Counts even_counts = count_at(even, query.prim_refs, axis);
        best.offer(query, axis, even, even_counts);
        const Positions adapted = adapted_positions(query.box, axis, even, even_counts, weight);
        best.offer(query, axis, adapted, count_at(adapted, query.prim_refs, axis));
    }
    if (!best.plane) return std::nullopt;
    return evaluate_plane(query, *best.plane);
}

}  // namespace coppice::inline v0
