// Equal probabilities, equidistant along a Morton curve. Compared with a uniform sample it has no
// clusters and no gaps.
// Source: [Tessari2023] sec. 3.2.

#include "sample/stratified.h"

namespace coppice::inline v0 {

InclusionProbability StratifiedSampler::choose(std::span<const float> diagonals,
                                               std::uint32_t count,
                                               const SampleOptions& /*options*/) const {
    return {static_cast<double>(count) / static_cast<double>(diagonals.size()), 0.0};
}

}  // namespace coppice::inline v0
