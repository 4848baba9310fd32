#include "coppice/builders/draw_sample.h"

#include "coppice/base/error.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <string>

namespace coppice::inline v0 {
namespace {

// Checks the contract of a custom sampler. The library's own samplers satisfy it by construction.
void require_sound(const Sample& sample, std::uint32_t primitive_count) {
    const auto fail = [](const std::string& what) {
        throw Error(ErrorCode::invalid_argument, "the custom sampler " + what);
    };
    if (sample.ids.empty()) fail("drew no primitives");
    if (sample.ids.back() >= primitive_count) {
        fail("drew id " + std::to_string(sample.ids.back()) + ", but there are " +
             std::to_string(primitive_count) + " primitives");
    }
    if (std::adjacent_find(sample.ids.begin(), sample.ids.end(), std::greater_equal<>()) !=
        sample.ids.end()) {
        fail("drew ids that are not strictly ascending");
    }
    if (!sample.weights.empty() && sample.weights.size() != sample.ids.size()) {
        fail("returned " + std::to_string(sample.weights.size()) + " weights for " +
             std::to_string(sample.ids.size()) + " primitives");
    }
}

}  // namespace

Sample draw_sample(PrimitiveSetView primitives, const SampleOptions& options) {
    const Sampler& sampler = sampler_of(options);
    const std::uint32_t count = sample_count(primitives.size(), options.rate);
    if (count < primitives.size()) {
        Sample sample = sampler.draw(primitives, count, options);
        if (options.custom_sampler) require_sound(sample, primitives.size());
        return sample;
    }
    Sample all{std::vector<std::uint32_t>(count), {}, options};
    std::iota(all.ids.begin(), all.ids.end(), 0U);
    return all;
}

}  // namespace coppice::inline v0
