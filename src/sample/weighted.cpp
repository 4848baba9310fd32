// The inclusion probability grows with the diagonal d of a primitive's box: p = min(1, c k (u / n +
// (1 - u) d / sum of all d)) for k draws from n primitives. The uniform share u is the same for
// all, so that every primitive can be drawn. A uniform sample would miss the few huge triangles
// that cost most rays. The constant c redistributes what the clamp to 1 cuts off: it is the fixed
// point at which all p sum up to k.
// Source: [Tessari2023] sec. 3.2; the uniform share is this project's.

#include "sample/weighted.h"

#include <algorithm>

namespace coppice::inline v0 {
namespace {

// The set of clamped primitives only grows, by less in every round.
constexpr int max_rounds = 16;

// The least uniform share. Without it, primitives with a diagonal of 0 could never be drawn, and
// there might be too few others.
constexpr double least_share = 0x1.0p-20;

}  // namespace

InclusionProbability WeightedSampler::choose(std::span<const float> diagonals, std::uint32_t count,
                                             const SampleOptions& options) const {
    double sum = 0.0;
    for (const float diagonal : diagonals) {
        sum += static_cast<double>(diagonal);
    }
    const double k = count;
    const double share = sum > 0.0 ? std::max(options.uniform_share, least_share) : 1.0;
    const double at_zero = k * share / static_cast<double>(diagonals.size());
    const double slope = sum > 0.0 ? k * (1.0 - share) / sum : 0.0;

    double factor = 1.0;
    double clamped = -1.0;
    for (int round = 0; round < max_rounds; ++round) {
        const InclusionProbability now{factor * at_zero, factor * slope};
        double at_one = 0.0;
        double others = 0.0;
        for (const float diagonal : diagonals) {
            const double raw = at_zero + slope * static_cast<double>(diagonal);
            const bool is_clamped = now(diagonal) >= 1.0;
            at_one += is_clamped ? 1.0 : 0.0;
            others += is_clamped ? 0.0 : raw;
        }
        if (at_one == clamped || !(others > 0.0)) break;
        clamped = at_one;
        factor = (k - at_one) / others;
    }
    return {factor * at_zero, factor * slope};
}

}  // namespace coppice::inline v0
