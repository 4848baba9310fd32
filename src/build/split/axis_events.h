#pragma once

#include "coppice/build/split_finder.h"

#include "build/split/best_split.h"
#include "build/split/evaluate_plane.h"

#include <cstdint>
#include <vector>

namespace coppice {

/// Ends of fragments on one axis as sort_key()s, by kind. A flat fragment is one planar event.
struct AxisEvents {
    std::vector<std::uint64_t> starts;
    std::vector<std::uint64_t> ends;
    std::vector<std::uint64_t> planars;

    /// Both ends of a fragment.
    void add(const Fragment& fragment, Axis axis);

    /// Some of the ends of a fragment.
    void add(const Fragment& fragment, Axis axis, bool with_start, bool with_end);

    [[nodiscard]] std::size_t count() const noexcept {
        return starts.size() + ends.size() + planars.size();
    }
};

/// Offers the split at every event inside the node. `counts`: what is below and above a plane
/// before the first event. Sorts the events.
void sweep_events(AxisEvents& events, const PlaneEvaluator& evaluator, SplitCounts counts,
                  BestSplit& best);

}  // namespace coppice
