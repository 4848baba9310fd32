#pragma once

#include "coppice/sample/sampler.h"

namespace coppice::inline v0 {

/// Every primitive with the same probability, without replacement.
class UniformSampler final : public Sampler {
public:
    [[nodiscard]] Sample draw(PrimitiveSetView primitives, std::uint32_t count,
                              const SampleOptions& options) const override;
};

}  // namespace coppice::inline v0
