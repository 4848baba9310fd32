// Finds the best plane of a small node; included once for each instruction set, in a namespace of
// its own. See plane_costs.cpp.

constexpr std::size_t lane_count = 8;
constexpr double infinity = std::numeric_limits<double>::infinity();

using Floats = float __attribute__((vector_size(4 * lane_count)));
using Masks = std::int32_t __attribute__((vector_size(4 * lane_count)));

// Costs are in double, half of the lanes at a time: vectors wider than registers compile badly.
constexpr std::size_t half_count = lane_count / 2;
using HalfFloats = float __attribute__((vector_size(4 * half_count)));
using Doubles = double __attribute__((vector_size(8 * half_count)));
using DoubleMasks = std::int64_t __attribute__((vector_size(8 * half_count)));

COPPICE_IN_KERNEL Floats load(const float* from) noexcept {
    Floats lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

COPPICE_IN_KERNEL Doubles to_double(const Floats& lanes, std::size_t half) noexcept {
    std::array<HalfFloats, 2> halves;
    std::memcpy(halves.data(), &lanes, sizeof lanes);
    return __builtin_convertvector(halves[half], Doubles);
}

// Sums of ones: a true comparison is -1 in each lane.
struct Ones {
    Masks sum{};

    COPPICE_IN_KERNEL void add_where(const Masks& mask, float /*weight*/) noexcept { sum -= mask; }

    [[nodiscard]] COPPICE_IN_KERNEL Floats get() const noexcept {
        return __builtin_convertvector(sum, Floats);
    }
};

struct Weights {
    Floats sum{};

    COPPICE_IN_KERNEL void add_where(const Masks& mask, float weight) noexcept {
        const Floats all = weight - Floats{};
        sum += reinterpret_cast<Floats>(reinterpret_cast<Masks>(all) & mask);
    }

    [[nodiscard]] COPPICE_IN_KERNEL Floats get() const noexcept { return sum; }
};

COPPICE_IN_KERNEL Doubles costs_of(const CostTerms& terms, const Doubles& at, const Doubles& below,
                                   const Doubles& above) noexcept {
    const Doubles p_below =
        (terms.cap_area + terms.side_perimeter * (at - terms.lower)) * terms.inverse_area;
    const Doubles p_above =
        (terms.cap_area + terms.side_perimeter * (terms.upper - at)) * terms.inverse_area;
    const Doubles intersection = below * above == 0.0 ? terms.empty_intersection - Doubles{}
                                                      : terms.intersection - Doubles{};
    return terms.traversal + intersection * (p_below * below + p_above * above);
}

// The cheapest plane so far in each lane.
class LaneBest {
public:
    // Offers planes; those that are not inside the node do not count.
    COPPICE_IN_KERNEL void offer(const Doubles& at, const Doubles& any_cost,
                                 const CostTerms& terms) noexcept {
        const DoubleMasks is_inside = (at > terms.lower) & (at < terms.upper);
        const Doubles cost = is_inside ? any_cost : infinity - Doubles{};
        const DoubleMasks is_better = (cost < cost_) | ((cost == cost_) & (at < position_));
        cost_ = is_better ? cost : cost_;
        position_ = is_better ? at : position_;
    }

    [[nodiscard]] COPPICE_IN_KERNEL BestPlane get() const noexcept {
        double cost = cost_[0];
        double position = position_[0];
        for (std::size_t lane = 1; lane < half_count; ++lane) {
            const bool is_better =
                (cost_[lane] < cost) | ((cost_[lane] == cost) & (position_[lane] < position));
            cost = is_better ? cost_[lane] : cost;
            position = is_better ? position_[lane] : position;
        }
        return {cost, static_cast<float>(position)};
    }

private:
    Doubles cost_ = infinity - Doubles{};
    Doubles position_ = infinity - Doubles{};
};

template <typename Sum>
COPPICE_IN_KERNEL Floats weight_in_planes(const AxisEnds& ends, const Floats& position) noexcept {
    Sum in_plane;
    for (std::size_t i = 0; i < ends.count; ++i) {
        in_plane.add_where((ends.lower[i] == position) & (ends.upper[i] == position),
                           ends.weight[i]);
    }
    return in_plane.get();
}

template <typename Sum>
COPPICE_IN_KERNEL void offer_planes(const AxisEnds& ends, const CostTerms& terms,
                                    const Floats& position, LaneBest& best) noexcept {
    Sum below_sum;
    Sum above_sum;
    for (std::size_t i = 0; i < ends.count; ++i) {
        below_sum.add_where(ends.lower[i] < position, ends.weight[i]);
        above_sum.add_where(ends.upper[i] > position, ends.weight[i]);
    }
    const Floats in_plane_sum = ends.has_planar ? weight_in_planes<Sum>(ends, position) : Floats{};
    for (std::size_t half = 0; half < 2; ++half) {
        const Doubles at = to_double(position, half);
        const Doubles below = to_double(below_sum.get(), half);
        const Doubles above = to_double(above_sum.get(), half);
        if (!ends.has_planar) {
            best.offer(at, costs_of(terms, at, below, above), terms);
            continue;
        }
        const Doubles in_plane = to_double(in_plane_sum, half);
        const Doubles cost_if_below = costs_of(terms, at, below + in_plane, above);
        const Doubles cost_if_above = costs_of(terms, at, below, above + in_plane);
        best.offer(at, cost_if_above < cost_if_below ? cost_if_above : cost_if_below, terms);
    }
}

// What reaches below a position less what reaches above it: never falls with the position.
COPPICE_IN_KERNEL float excess_below(const AxisEnds& ends, float position) noexcept {
    Floats excess{};
    for (std::size_t i = 0; i < ends.count; i += lane_count) {
        const Masks below = load(ends.lower + i) < position;
        const Masks above = load(ends.upper + i) > position;
        const auto weight = reinterpret_cast<Masks>(load(ends.weight + i));
        excess += reinterpret_cast<Floats>(weight & below);
        excess -= reinterpret_cast<Floats>(weight & above);
    }
    float sum = 0.0F;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        sum += excess[lane];
    }
    return sum;
}

// Starts after `last_start` and ends before `first_end` cost more than another plane.
struct Bracket {
    float last_start;
    float first_end;
};

// The first start and the last end inside the node are never left out: the cheaper plane that the
// others are beaten by may be the node's face.
COPPICE_IN_KERNEL void widen(Bracket& bracket, const AxisEnds& ends, float lower,
                             float upper) noexcept {
    float first_start = upper;
    float last_end = lower;
    for (std::size_t i = 0; i < ends.count; ++i) {
        const float start = ends.lower[i];
        const float end = ends.upper[i];
        first_start = (start > lower) & (start < first_start) ? start : first_start;
        last_end = (end < upper) & (end > last_end) ? end : last_end;
    }
    bracket.last_start = std::max(bracket.last_start, first_start);
    bracket.first_end = std::min(bracket.first_end, last_end);
}

// Bisects for where as much reaches below as above.
COPPICE_IN_KERNEL Bracket find_bracket(const AxisEnds& ends, float lower, float upper) noexcept {
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

// The planes that come into question, filled up to whole vectors.
struct Candidates {
    std::array<float, 2 * small_node_capacity + lane_count> position;
    std::size_t count = 0;
};

COPPICE_IN_KERNEL void list_candidates(const AxisEnds& ends, const CostTerms& terms,
                                       Candidates& list) noexcept {
    const auto lower = static_cast<float>(terms.lower);
    const auto upper = static_cast<float>(terms.upper);
    const Bracket bracket = find_bracket(ends, lower, upper);
    std::size_t count = 0;
    for (std::size_t i = 0; i < ends.count; ++i) {
        list.position[count] = ends.lower[i];
        count += (ends.lower[i] > lower) & (ends.lower[i] <= bracket.last_start) ? 1U : 0U;
    }
    for (std::size_t i = 0; i < ends.count; ++i) {
        list.position[count] = ends.upper[i];
        count += (ends.upper[i] < upper) & (ends.upper[i] >= bracket.first_end) ? 1U : 0U;
    }
    std::fill_n(list.position.begin() + static_cast<std::ptrdiff_t>(count), lane_count,
                std::numeric_limits<float>::infinity());
    list.count = count;
}

template <typename Sum>
COPPICE_IN_KERNEL BestPlane best_plane_by(const AxisEnds& ends, const CostTerms& terms) noexcept {
    constexpr std::size_t few = 16;  // ends of so many PrimRefs are sooner all evaluated
    LaneBest best;
    if (ends.count <= few) {
        for (std::size_t i = 0; i < ends.count; i += lane_count) {
            offer_planes<Sum>(ends, terms, load(ends.lower + i), best);
            offer_planes<Sum>(ends, terms, load(ends.upper + i), best);
        }
        return best.get();
    }
    Candidates candidates;
    list_candidates(ends, terms, candidates);
    for (std::size_t i = 0; i < candidates.count; i += lane_count) {
        offer_planes<Sum>(ends, terms, load(&candidates.position[i]), best);
    }
    return best.get();
}

BestPlane find_best_plane(const AxisEnds& ends, const CostTerms& terms) noexcept {
    const CostTerms own_terms = terms;
    return ends.are_weights_one ? best_plane_by<Ones>(ends, own_terms)
                                : best_plane_by<Weights>(ends, own_terms);
}
