#pragma once

#include "sample/equidistant.h"

namespace coppice::inline v0 {

/// The sampler "stratified": equal probabilities, one draw from each stretch of a Morton curve.
class StratifiedSampler final : public EquidistantSampler {
public:
    [[nodiscard]] bool uses_uniform_share() const noexcept override { return false; }

private:
    [[nodiscard]] InclusionProbability choose(std::span<const float> diagonals, std::uint32_t count,
                                              const SampleOptions& options) const override;
};

}  // namespace coppice::inline v0
