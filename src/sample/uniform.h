#pragma once

#include "coppice/sample/sampler.h"

namespace coppice::inline v0 {

/// The sampler "uniform": equal probabilities, without replacement.
class UniformSampler final : public Sampler {
public:
    [[nodiscard]] Sample draw(PrimitiveSetView primitives, std::uint32_t count,
                              const SampleOptions& options) const override;

    [[nodiscard]] bool uses_uniform_share() const noexcept override { return false; }
};

}  // namespace coppice::inline v0
