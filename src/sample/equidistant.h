#pragma once

#include "coppice/sample/sampler.h"

#include <algorithm>
#include <span>

namespace coppice::inline v0 {

/// The inclusion probability of a primitive as a function of its box's diagonal: linear, clamped at
/// 1.
struct InclusionProbability {
    double at_zero = 0.0;
    double slope = 0.0;

    [[nodiscard]] double operator()(float diagonal) const noexcept {
        return std::min(1.0, at_zero + slope * static_cast<double>(diagonal));
    }
};

/// Systematic sampling: draws primitives at equal distances along the sum of their inclusion
/// probabilities, in Morton order of their centroids.
class EquidistantSampler : public Sampler {
public:
    [[nodiscard]] Sample draw(PrimitiveSetView primitives, std::uint32_t count,
                              const SampleOptions& options) const override;

private:
    /// The inclusion probabilities for primitives with these diagonals. They sum up to `count`.
    [[nodiscard]] virtual InclusionProbability choose(std::span<const float> diagonals,
                                                      std::uint32_t count,
                                                      const SampleOptions& options) const = 0;
};

}  // namespace coppice::inline v0
