// Counts the PrimRefs on both sides of the planes of a small node, and evaluates the heuristic
// there. Each PrimRef is compared with vectors of planes, without branches and without sorting.
// Cost: O(PrimRefs planes / 8). That is less than sorting up to about 64 PrimRefs, and most nodes
// of a k-d tree are that small.
//
// If there are many ends, half of them are left out. Between ends the cost is linear in the
// position. It falls where more PrimRefs reach above the position than below, and rises elsewhere.
// So before that turning point only starts can be cheapest, and after it only ends.
//
// No fused multiply-add may be used here: costs must equal those of the scalar code.

#include "simd/set.h"

#if defined(COPPICE_BUILDERS_KERNELS_PLANE_KERNELS_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_BUILDERS_KERNELS_PLANE_KERNELS_H
#else
#define COPPICE_BUILDERS_KERNELS_PLANE_KERNELS_H
#endif

#include "builders/kernels/plane_costs.h"
#include "cost/split_cost.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

constexpr std::size_t lane_count = 8;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Constructors are written out, because those that the compiler generates are not compiled for the
// instruction set.

// Counts PrimRefs of weight 1.
struct Ones {
    COPPICE_LANES Ones() noexcept : sum(make_counters()) {}

    COPPICE_LANES void add_where(const Mask& mask, float /*weight*/) noexcept { count(sum, mask); }

    [[nodiscard]] COPPICE_LANES Lanes get() const noexcept { return to_lanes(sum); }

    Counters sum;
};

struct Weights {
    COPPICE_LANES Weights() noexcept : sum(broadcast(0.0F)) {}

    COPPICE_LANES void add_where(const Mask& mask, float weight) noexcept {
        sum = sum + keep(mask, broadcast(weight));
    }

    [[nodiscard]] COPPICE_LANES Lanes get() const noexcept { return sum; }

    Lanes sum;
};

// CostTerms, repeated in all lanes.
struct LaneTerms {
    COPPICE_LANES explicit LaneTerms(const CostTerms& terms) noexcept
        : lower(broadcast_double(terms.lower)),
          upper(broadcast_double(terms.upper)),
          cap_area(broadcast_double(terms.cap_area)),
          side_perimeter(broadcast_double(terms.side_perimeter)),
          inverse_area(broadcast_double(terms.inverse_area)),
          traversal(broadcast_double(terms.traversal)),
          intersection(broadcast_double(terms.intersection)),
          empty_intersection(broadcast_double(terms.empty_intersection)) {}

    Doubles lower;
    Doubles upper;
    Doubles cap_area;
    Doubles side_perimeter;
    Doubles inverse_area;
    Doubles traversal;
    Doubles intersection;
    Doubles empty_intersection;
};

COPPICE_LANES Doubles costs_of(const LaneTerms& terms, const Doubles& at, const Doubles& below,
                               const Doubles& above) noexcept {
    const auto share_of = [&](const Doubles& length) {
        return sah::COPPICE_SIMD_SET::area_share(terms.cap_area, terms.side_perimeter, length,
                                                 terms.inverse_area);
    };
    const DoubleMask has_empty_side = is_equal(below * above, broadcast_double(0.0));
    return sah::COPPICE_SIMD_SET::split_cost(
        terms.traversal, select(has_empty_side, terms.empty_intersection, terms.intersection),
        share_of(at - terms.lower), below, share_of(terms.upper - at), above);
}

// The cheapest plane so far in each lane.
class LaneBest {
public:
    COPPICE_LANES LaneBest() noexcept
        : cost_(broadcast_double(infinity)), position_(broadcast_double(infinity)) {}

    // Considers planes in all lanes. Planes that are not inside the node are ignored.
    COPPICE_LANES void offer(const Doubles& at, const Doubles& any_cost,
                             const LaneTerms& terms) noexcept {
        const DoubleMask is_inside = is_less(terms.lower, at) & is_less(at, terms.upper);
        const Doubles cost = select(is_inside, any_cost, broadcast_double(infinity));
        const DoubleMask is_better =
            is_less(cost, cost_) | (is_equal(cost, cost_) & is_less(at, position_));
        cost_ = select(is_better, cost, cost_);
        position_ = select(is_better, at, position_);
    }

    [[nodiscard]] COPPICE_LANES BestPlane get() const noexcept {
        alignas(32) std::array<double, half_count> costs;
        alignas(32) std::array<double, half_count> positions;
        store(cost_, costs.data());
        store(position_, positions.data());
        double cost = costs[0];
        double position = positions[0];
        for (std::size_t lane = 1; lane < half_count; ++lane) {
            const double other = costs[lane];
            const double at = positions[lane];
            const bool is_better = (other < cost) | ((other == cost) & (at < position));
            cost = is_better ? other : cost;
            position = is_better ? at : position;
        }
        return {cost, static_cast<float>(position)};
    }

private:
    static constexpr std::size_t half_count = lane_count / 2;

    Doubles cost_;
    Doubles position_;
};

template <typename Sum>
COPPICE_LANES Lanes weight_in_planes(const AxisEnds& ends, const Lanes& position) noexcept {
    Sum in_plane;
    for (std::size_t i = 0; i < ends.count; ++i) {
        in_plane.add_where(is_equal(broadcast(ends.lower[i]), position) &
                               is_equal(broadcast(ends.upper[i]), position),
                           ends.weight[i]);
    }
    return in_plane.get();
}

// Considers planes at four positions, with the sums of weights below, above and in them.
COPPICE_LANES void offer_half(const Quad& position, const Quad& below_sum, const Quad& above_sum,
                              const Quad& in_plane_sum, bool has_planar, const LaneTerms& terms,
                              LaneBest& best) noexcept {
    const Doubles at = to_doubles(position);
    const Doubles below = to_doubles(below_sum);
    const Doubles above = to_doubles(above_sum);
    if (!has_planar) {
        best.offer(at, costs_of(terms, at, below, above), terms);
        return;
    }
    const Doubles in_plane = to_doubles(in_plane_sum);
    const Doubles cost_if_below = costs_of(terms, at, below + in_plane, above);
    const Doubles cost_if_above = costs_of(terms, at, below, above + in_plane);
    best.offer(at, select(is_less(cost_if_above, cost_if_below), cost_if_above, cost_if_below),
               terms);
}

template <typename Sum>
COPPICE_LANES void offer_planes(const AxisEnds& ends, const LaneTerms& terms, const Lanes& position,
                                LaneBest& best) noexcept {
    Sum below_sum;
    Sum above_sum;
    for (std::size_t i = 0; i < ends.count; ++i) {
        below_sum.add_where(is_less(broadcast(ends.lower[i]), position), ends.weight[i]);
        above_sum.add_where(is_less(position, broadcast(ends.upper[i])), ends.weight[i]);
    }
    const Lanes below = below_sum.get();
    const Lanes above = above_sum.get();
    const Lanes in_plane =
        ends.has_planar ? weight_in_planes<Sum>(ends, position) : broadcast(0.0F);
    offer_half(lower_half(position), lower_half(below), lower_half(above), lower_half(in_plane),
               ends.has_planar, terms, best);
    offer_half(upper_half(position), upper_half(below), upper_half(above), upper_half(in_plane),
               ends.has_planar, terms, best);
}

// The weight that reaches below a position minus the weight that reaches above it; monotonic in the
// position.
COPPICE_LANES float excess_below(const AxisEnds& ends, float position) noexcept {
    const Lanes at = broadcast(position);
    Lanes excess = broadcast(0.0F);
    for (std::size_t i = 0; i < ends.count; i += lane_count) {
        const Lanes weight = load_unaligned(ends.weight + i);
        excess = excess + keep(is_less(load_unaligned(ends.lower + i), at), weight);
        excess = excess - keep(is_less(at, load_unaligned(ends.upper + i)), weight);
    }
    alignas(32) std::array<float, lane_count> parts;
    store(excess, parts);
    float sum = 0.0F;
    for (const float part : parts) {
        sum += part;
    }
    return sum;
}

// A range of positions that contains the turning point of the cost. Starts after `last_start` and
// ends before `first_end` cannot be cheapest.
struct Bracket {
    float last_start;
    float first_end;
};

// Widens a bracket to include the first start and the last end inside the node. Those are never
// left out: the cheaper plane that excludes others may be the node's face.
COPPICE_LANES void widen(Bracket& bracket, const AxisEnds& ends, float lower,
                         float upper) noexcept {
    float first_start = upper;
    float last_end = lower;
    for (std::size_t i = 0; i < ends.count; ++i) {
        const float start = ends.lower[i];
        const float end = ends.upper[i];
        first_start = ((start > lower) & (start < first_start)) ? start : first_start;
        last_end = ((end < upper) & (end > last_end)) ? end : last_end;
    }
    bracket.last_start = std::max(bracket.last_start, first_start);
    bracket.first_end = std::min(bracket.first_end, last_end);
}

// Finds by bisection where as much weight reaches below as above.
COPPICE_LANES Bracket find_bracket(const AxisEnds& ends, float lower, float upper) noexcept {
    constexpr int step_count = 4;
    Bracket bracket{upper, lower};
    for (int step = 0; step < step_count; ++step) {
        const float middle = 0.5F * bracket.first_end + 0.5F * bracket.last_start;
        const float excess = excess_below(ends, middle);
        if (excess == 0.0F) break;
        (excess > 0.0F ? bracket.last_start : bracket.first_end) = middle;
    }
    widen(bracket, ends, lower, upper);
    return bracket;
}

// The candidate planes, padded to whole vectors.
struct Candidates {
    std::array<float, 2 * small_node_capacity + lane_count> position;
    std::size_t count = 0;
};

COPPICE_LANES void list_candidates(const AxisEnds& ends, const CostTerms& terms,
                                   Candidates& list) noexcept {
    const auto lower = static_cast<float>(terms.lower);
    const auto upper = static_cast<float>(terms.upper);
    const Bracket bracket = find_bracket(ends, lower, upper);
    std::size_t count = 0;
    for (std::size_t i = 0; i < ends.count; ++i) {
        list.position[count] = ends.lower[i];
        count += ((ends.lower[i] > lower) & (ends.lower[i] <= bracket.last_start)) ? 1U : 0U;
    }
    for (std::size_t i = 0; i < ends.count; ++i) {
        list.position[count] = ends.upper[i];
        count += ((ends.upper[i] < upper) & (ends.upper[i] >= bracket.first_end)) ? 1U : 0U;
    }
    std::fill_n(list.position.begin() + static_cast<std::ptrdiff_t>(count), lane_count,
                std::numeric_limits<float>::infinity());
    list.count = count;
}

template <typename Sum>
COPPICE_LANES BestPlane best_plane_by(const AxisEnds& ends, const CostTerms& terms) noexcept {
    constexpr std::size_t few = 16;  // for fewer PrimRefs, evaluating all ends is faster
    const LaneTerms lane_terms(terms);
    LaneBest best;
    if (ends.count <= few) {
        for (std::size_t i = 0; i < ends.count; i += lane_count) {
            offer_planes<Sum>(ends, lane_terms, load_unaligned(ends.lower + i), best);
            offer_planes<Sum>(ends, lane_terms, load_unaligned(ends.upper + i), best);
        }
        return best.get();
    }
    Candidates candidates;
    list_candidates(ends, terms, candidates);
    for (std::size_t i = 0; i < candidates.count; i += lane_count) {
        offer_planes<Sum>(ends, lane_terms, load_unaligned(&candidates.position[i]), best);
    }
    return best.get();
}

BestPlane find_best_plane(const AxisEnds& ends, const CostTerms& terms) noexcept {
    return ends.are_weights_one ? best_plane_by<Ones>(ends, terms)
                                : best_plane_by<Weights>(ends, terms);
}

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

COPPICE_SIMD_END

#endif
