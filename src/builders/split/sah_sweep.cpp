// The thesis's rule: sweeps the longest axis first, and another axis only if that has no acceptable
// split. This is pbrt's scheme, not the minimum over all three axes. Cost: O(n log n) a node and
// axis.
// Source: [Tsiompikas2022] sec. 4.3.1, [Pharr2016] sec. 4.4.2.

#include "builders/split/sah_sweep.h"

#include "builders/split/axis_sweep.h"

namespace coppice::inline v0 {

std::optional<SplitCandidate> SahSweep::find(const SplitQuery& query) const {
    std::optional<SplitCandidate> best;
    Axis axis = query.box.longest_axis();
    for (std::size_t tried = 0; tried < all_axes.size(); ++tried, axis = next_axis(axis)) {
        const auto split = sweep_axis(query, axis);
        if (split && (!best || split->cost < best->cost)) best = split;
        if (best && best->cost < query.acceptable_cost) return best;
    }
    return best;
}

}  // namespace coppice::inline v0
