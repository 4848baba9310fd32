// The first hits of a ray in order, in an array of fixed size. Each new hit is inserted by moving
// from the end, and the last one drops out when the array is full. Traversals find hits nearly in
// order, so that the right place is usually near the end.
#pragma once

#include "coppice/geom/ray.h"

#include <array>
#include <cstddef>
#include <limits>
#include <span>

namespace coppice::inline v0 {

/// The order of hits: by distance, then by id.
[[nodiscard]] inline bool is_before(const Hit& a, const Hit& b) noexcept {
    return a.t < b.t || (a.t == b.t && a.prim < b.prim);
}

/// A sorted list of hits, at most as many as a span has room for. Inserting a hit twice has no
/// effect.
class HitList {
public:
    /// Collects hits that come after `*after` in order, or all hits if it is null.
    HitList(std::span<Hit> hits, const Hit* after) noexcept
        : hits_(hits), has_after_(after != nullptr), after_(has_after_ ? *after : Hit{}) {}

    /// Inserts a hit, unless it does not come after `*after`, is in the list already, or is farther
    /// than the last of a full list.
    void insert(const Hit& hit) noexcept {
        if (has_after_ && !is_before(after_, hit)) return;
        std::size_t place = size_;
        while (place > 0 && is_before(hit, hits_[place - 1])) {
            --place;
        }
        if (place == hits_.size()) return;
        // The same triangle, found through another leaf.
        if (place > 0 && !is_before(hits_[place - 1], hit)) return;
        if (size_ < hits_.size()) ++size_;
        for (std::size_t i = size_ - 1; i > place; --i) {
            hits_[i] = hits_[i - 1];
        }
        hits_[place] = hit;
    }

    [[nodiscard]] std::size_t size() const noexcept { return size_; }

    [[nodiscard]] bool is_full() const noexcept { return size_ == hits_.size(); }

    /// No hit closer than this distance is wanted.
    [[nodiscard]] float first_distance() const noexcept {
        return has_after_ ? after_.t : -std::numeric_limits<float>::infinity();
    }

    /// The distance of the last hit. The list must not be empty.
    [[nodiscard]] float last_distance() const noexcept { return hits_[size_ - 1].t; }

private:
    std::span<Hit> hits_;
    std::size_t size_ = 0;
    bool has_after_;
    Hit after_;
};

/// Counts hits by repeated calls of a query that returns a limited number of hits at a time.
/// `find(std::span<Hit> hits, const Hit* after)` must behave like intersect_all().
template <typename Find>
[[nodiscard]] std::size_t count_by(Find&& find) noexcept {
    constexpr std::size_t at_a_time = 64;
    std::array<Hit, at_a_time> hits;
    std::size_t count = 0;
    for (const Hit* after = nullptr;;) {
        const std::size_t found = find(std::span<Hit>(hits), after);
        count += found;
        if (found < at_a_time) return count;
        after = &hits.back();
    }
}

}  // namespace coppice::inline v0
