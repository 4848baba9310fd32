#pragma once

#include "scenes/ray_sets.h"
#include "tracers/contestant.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coppice::lab {

/// What a contestant found: closest hits, or for shadow rays whether there is any.
struct Answers {
    std::vector<Hit> hits;
    std::vector<std::uint8_t> flags;
};

/// How rays of one kind are handed over: one by one unless `is_batched`.
[[nodiscard]] Queries queries_for(RayKind kind, bool is_batched) noexcept;

/// Traces all rays of one kind with at most so many threads.
void trace_answers(const Contestant& contestant, RayKind kind, std::span<const Ray> rays,
                   Queries queries, int threads, Answers& answers);

/// How many answers differ from those of the reference: in distance, or in whether there is a hit.
[[nodiscard]] std::uint64_t count_mismatches(const Answers& answers, const Answers& reference);

}  // namespace coppice::lab
