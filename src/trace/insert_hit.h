#pragma once

#include "coppice/geom/ray.h"

#include <cstddef>
#include <span>

namespace coppice {

/// True if `a` comes before `b` in the order of t, then of id.
[[nodiscard]] inline bool comes_before(const Hit& a, const Hit& b) noexcept {
    return a.t != b.t ? a.t < b.t : a.prim < b.prim;
}

/// Inserts a hit into the first `count` of `hits`, which are in order; the last one falls out when
/// they are full. Leaves out one that does not come after `*after` and one that is there already.
inline void insert_hit(const Hit& hit, const Hit* after, std::span<Hit> hits,
                       std::size_t& count) noexcept {
    if (after != nullptr && !comes_before(*after, hit)) return;
    std::size_t place = count;
    while (place > 0 && comes_before(hit, hits[place - 1]))
        --place;
    if (place > 0 && !comes_before(hits[place - 1], hit)) return;
    if (place == hits.size()) return;
    if (count < hits.size()) ++count;
    for (std::size_t i = count - 1; i > place; --i) {
        hits[i] = hits[i - 1];
    }
    hits[place] = hit;
}

}  // namespace coppice
