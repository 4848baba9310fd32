#include "bench/answers.h"

#include "coppice/base/parallel.h"

#include "tracers/hit_agreement.h"

#include <cstddef>

namespace coppice::lab {

Queries queries_for(RayKind kind, bool is_batched) noexcept {
    if (!is_batched) return Queries::single;
    // Rays of neighbouring pixels start next to each other; primary and shadow rays go the same
    // way.
    return kind == RayKind::diffuse ? Queries::batched : Queries::coherent;
}

void trace_answers(const Contestant& contestant, RayKind kind, std::span<const Ray> rays,
                   Queries queries, int threads, Answers& answers) {
    constexpr std::size_t chunk_size = 4096;
    const bool is_any_hit = kind == RayKind::shadow;
    answers.hits.resize(is_any_hit ? 0 : rays.size());
    answers.flags.resize(is_any_hit ? rays.size() : 0);
    run_with_threads(threads, [&] {
        parallel_for_chunks(rays.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
            const std::size_t count = end - begin;
            const auto chunk = rays.subspan(begin, count);
            if (is_any_hit) {
                contestant.occluded(chunk, std::span(answers.flags).subspan(begin, count), queries);
            } else {
                contestant.intersect(chunk, std::span(answers.hits).subspan(begin, count), queries);
            }
        });
    });
}

std::uint64_t count_mismatches(const Answers& answers, const Answers& reference) {
    std::uint64_t count = count_mismatches(answers.hits, reference.hits);
    for (std::size_t i = 0; i < reference.flags.size(); ++i) {
        count += answers.flags[i] == reference.flags[i] ? 0 : 1;
    }
    return count;
}

}  // namespace coppice::lab
