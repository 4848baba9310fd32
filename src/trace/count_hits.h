#pragma once

#include "coppice/geom/ray.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace coppice::trace {

/// The number of hits of a ray, by a function that puts its first hits after a given one into a
/// span: some at a time, so that nothing is allocated and what several leaves hold counts once.
template <typename F>
[[nodiscard]] std::uint64_t count_hits(F&& first_hits_after) noexcept {
    std::array<Hit, 64> hits;
    Hit last;
    const Hit* after = nullptr;
    for (std::uint64_t total = 0;;) {
        const std::size_t count = first_hits_after(std::span<Hit>(hits), after);
        total += count;
        if (count < hits.size()) return total;
        last = hits.back();
        after = &last;
    }
}

}  // namespace coppice::trace
