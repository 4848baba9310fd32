#pragma once

#include "sample/equidistant.h"

namespace coppice::inline v0 {

/// The sampler "weighted": greater probabilities for larger primitives, one draw from each stretch
/// of a Morton curve.
class WeightedSampler final : public EquidistantSampler {
    [[nodiscard]] InclusionProbability choose(std::span<const float> diagonals, std::uint32_t count,
                                              const SampleOptions& options) const override;
};

}  // namespace coppice::inline v0
