#include "coppice/build/draw_sample.h"

#include <numeric>

namespace coppice {

Sample draw_sample(PrimitiveSetView primitives, const SampleOptions& options) {
    const Sampler& sampler = find_sampler(options.sampler);
    const std::uint32_t count = sample_count(primitives.size(), options.rate);
    Sample sample{{}, options};
    if (count == primitives.size()) {
        sample.ids.resize(count);
        std::iota(sample.ids.begin(), sample.ids.end(), 0U);
    } else {
        sample.ids = sampler.draw(primitives, count, options.seed);
    }
    return sample;
}

}  // namespace coppice
