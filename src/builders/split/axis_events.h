#pragma once

#include "coppice/builders/split_finder.h"

#include "builders/split/best_split.h"
#include "builders/split/evaluate_plane.h"

#include <cstdint>
#include <vector>

namespace coppice::inline v0 {

/// The ends of PrimRefs on one axis as sort_key()s, separated by kind. A flat PrimRef is one planar
/// event.
struct AxisEvents {
    std::vector<std::uint64_t> starts;
    std::vector<std::uint64_t> ends;
    std::vector<std::uint64_t> planars;

    /// Adds both ends of a PrimRef.
    void add(const PrimRef& prim_ref, Axis axis);

    /// Adds the chosen ends of a PrimRef.
    void add(const PrimRef& prim_ref, Axis axis, bool with_start, bool with_end);

    [[nodiscard]] std::size_t count() const noexcept {
        return starts.size() + ends.size() + planars.size();
    }
};

/// Offers the split at every event inside the node to `best`. `counts` holds the weights below and
/// above a plane before the first event. Sorts the events.
void sweep_events(AxisEvents& events, const PlaneEvaluator& evaluator, SplitCounts counts,
                  BestSplit& best);

}  // namespace coppice::inline v0
