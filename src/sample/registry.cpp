#include "coppice/base/error.h"
#include "coppice/base/named.h"
#include "coppice/sample/sampler.h"

#include "sample/stratified.h"
#include "sample/uniform.h"
#include "sample/weighted.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::inline v0 {

std::span<const SamplerEntry> sampler_registry() {
    static const UniformSampler uniform;
    static const StratifiedSampler stratified;
    static const WeightedSampler weighted;
    static const std::array entries{
        SamplerEntry{"uniform", "every primitive with the same probability, without replacement",
                     uniform},
        SamplerEntry{"stratified", "as uniform, equidistant along a Morton curve", stratified},
        SamplerEntry{"weighted",
                     "large primitives more often, equidistant along a Morton curve; each counts "
                     "1/p in costs",
                     weighted},
    };
    return entries;
}

const Sampler& find_sampler(std::string_view name) {
    return find_named(sampler_registry(), name, "sampler").sampler;
}

const Sampler& sampler_of(const SampleOptions& options) {
    return options.custom_sampler ? *options.custom_sampler : find_sampler(options.sampler);
}

void require_valid(const SampleOptions& options) {
    static_cast<void>(sample_count(1, options.rate));
    static_cast<void>(sampler_of(options));
    const double share = options.uniform_share;
    if (!(share >= 0.0 && share <= 1.0)) {
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("uniform share {} is outside [0, 1]", share));
    }
}

std::uint32_t sample_count(std::uint32_t count, double rate) {
    if (!(rate > 0.0 && rate <= 1.0)) {
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("sample rate {} is outside (0, 1]", rate));
    }
    const auto rounded = static_cast<std::uint32_t>(std::llround(rate * count));
    return std::clamp<std::uint32_t>(rounded, std::min(count, 1U), count);
}

}  // namespace coppice::inline v0
