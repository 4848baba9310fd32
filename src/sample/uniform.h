#pragma once

#include "coppice/sample/sampler.h"

namespace coppice {

/// Every primitive with the same probability, without replacement.
class UniformSampler final : public Sampler {
public:
    [[nodiscard]] std::vector<std::uint32_t> draw(PrimitiveSetView primitives, std::uint32_t count,
                                                  std::uint64_t seed) const override;
};

}  // namespace coppice
