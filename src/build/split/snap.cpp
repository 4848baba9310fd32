// Collects the fragment ends in the bins around a boundary and sweeps them, the counts before them
// known from the bins. Cost: O(n), and a sort of the events in the two bins.

#include "build/split/snap.h"

#include "build/split/axis_events.h"
#include "build/split/evaluate_plane.h"

namespace coppice {

void snap(const SplitQuery& query, const BinGrid& grid, const AxisBins& bins,
          const BinBoundary& boundary, BestSplit& best) {
    const Axis axis = boundary.plane.axis;
    SplitCounts counts;
    for (std::size_t bin = 0; bin < bin_count; ++bin) {
        if (bin + 1 < boundary.bin) counts.below += bins.starts[bin];
        if (bin + 1 >= boundary.bin) counts.above += bins.ends[bin];
    }
    AxisEvents events;
    const float origin = grid.origin[axis];
    const float bins_per_unit = grid.bins_per_unit[axis];
    const auto is_near = [&](float position) {
        return bin_of(position, origin, bins_per_unit) - (boundary.bin - 1) < 2;
    };
    for (const Fragment& fragment : query.fragments) {
        const bool starts = is_near(fragment.box.lower[axis]);
        const bool ends = is_near(fragment.box.upper[axis]);
        if (starts || ends) events.add(fragment, axis, starts, ends);
    }
    sweep_events(events, PlaneEvaluator(query.box, axis, query.cost), counts, best);
}

}  // namespace coppice
