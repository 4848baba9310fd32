// Uniform sampling without replacement. Every id gets a random key that depends on (seed, id)
// alone, and the ids with the smallest keys are drawn. So a sample is a subset of every larger
// sample of the same seed, which makes rates comparable, and threads and order do not matter. O(N).
// Source: [Tsiompikas2022] sec. 4.2 (takes the first elements of a shuffled array: the same
// distribution).

#include "sample/uniform.h"

#include "coppice/base/parallel.h"
#include "coppice/base/rng.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace coppice::inline v0 {
namespace {

struct KeyedId {
    std::uint64_t key;
    std::uint32_t id;
};

constexpr std::uint64_t highest_key = std::numeric_limits<std::uint64_t>::max();

// A key below which more than `count` keys lie, almost certainly. Keys are uniformly distributed,
// so that an expected number of `count` + 6 standard deviations suffices.
std::uint64_t key_above(std::uint32_t count, std::uint32_t of) {
    const double wanted = count + 6.0 * std::sqrt(count) + 40.0;
    return wanted < of ? static_cast<std::uint64_t>(std::ldexp(wanted / of, 64)) : highest_key;
}

// The ids whose keys are at most `highest`, with their keys.
std::vector<KeyedId> keyed_up_to(std::uint64_t highest, std::uint32_t id_count,
                                 std::uint64_t seed) {
    constexpr std::size_t chunk_size = 65536;
    std::vector<std::vector<KeyedId>> chunks((id_count + chunk_size - 1) / chunk_size);
    parallel_for_chunks(id_count, chunk_size, [&](std::size_t begin, std::size_t end) {
        for (auto id = static_cast<std::uint32_t>(begin); id < end; ++id) {
            const std::uint64_t key = random_bits(seed, id);
            if (key <= highest) chunks[begin / chunk_size].push_back({key, id});
        }
    });
    std::vector<KeyedId> keyed;
    for (const std::vector<KeyedId>& chunk : chunks) {
        keyed.insert(keyed.end(), chunk.begin(), chunk.end());
    }
    return keyed;
}

}  // namespace

Sample UniformSampler::draw(PrimitiveSetView primitives, std::uint32_t count,
                            const SampleOptions& options) const {
    std::vector<KeyedId> keyed =
        keyed_up_to(key_above(count, primitives.size()), primitives.size(), options.seed);
    if (keyed.size() < count) keyed = keyed_up_to(highest_key, primitives.size(), options.seed);
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

}  // namespace coppice::inline v0
