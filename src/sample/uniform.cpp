// Uniform sampling without replacement: every id gets a random key that depends on (seed, id)
// alone, and the ids of the smallest keys are drawn. So a smaller sample of a seed is part of every
// larger one, which makes rates comparable, and no thread or order can change it. O(N).
// Source: [Tsiompikas2022] sec. 4.2 (takes the first of a shuffled array, the same distribution).

#include "sample/uniform.h"

#include "coppice/base/rng.h"

#include <algorithm>
#include <utility>

namespace coppice {

Sample UniformSampler::draw(PrimitiveSetView primitives, std::uint32_t count,
                            const SampleOptions& options) const {
    struct KeyedId {
        std::uint64_t key;
        std::uint32_t id;
    };

    std::vector<KeyedId> keyed(primitives.size());
    for (std::uint32_t id = 0; id < primitives.size(); ++id) {
        keyed[id] = {random_bits(options.seed, id), id};
    }
    const auto drawn_end = keyed.begin() + count;
    const auto by_key = [](const KeyedId& a, const KeyedId& b) {
        return a.key != b.key ? a.key < b.key : a.id < b.id;
    };
    if (drawn_end != keyed.end()) std::nth_element(keyed.begin(), drawn_end, keyed.end(), by_key);

    std::vector<std::uint32_t> ids(count);
    std::transform(keyed.begin(), drawn_end, ids.begin(), [](const KeyedId& k) { return k.id; });
    std::sort(ids.begin(), ids.end());
    return {std::move(ids), {}, options};
}

}  // namespace coppice
