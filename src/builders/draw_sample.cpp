#include "coppice/builders/draw_sample.h"

#include <numeric>

namespace coppice::inline v0 {

Sample draw_sample(PrimitiveSetView primitives, const SampleOptions& options) {
    const Sampler& sampler = find_sampler(options.sampler);
    const std::uint32_t count = sample_count(primitives.size(), options.rate);
    if (count < primitives.size()) return sampler.draw(primitives, count, options);
    Sample all{std::vector<std::uint32_t>(count), {}, options};
    std::iota(all.ids.begin(), all.ids.end(), 0U);
    return all;
}

}  // namespace coppice::inline v0
