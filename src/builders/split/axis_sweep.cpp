#include "builders/split/axis_sweep.h"

#include "builders/split/axis_events.h"
#include "builders/split/best_split.h"

namespace coppice::inline v0 {

std::optional<SplitCandidate> sweep_axis(const SplitQuery& query, Axis axis) {
    AxisEvents events;
    events.starts.reserve(query.prim_refs.size());
    events.ends.reserve(query.prim_refs.size());
    for (const PrimRef& prim_ref : query.prim_refs) {
        events.add(prim_ref, axis);
    }
    BestSplit best;
    sweep_events(events, PlaneEvaluator(query.box, axis, query.cost),
                 {0.0, weight_of(query.prim_refs), 0.0}, best);
    return best.get();
}

std::optional<SplitCandidate> sweep_all_axes(const SplitQuery& query) {
    BestSplit best;
    for (const Axis axis : all_axes) {
        if (const auto split = sweep_axis(query, axis)) best.offer(*split);
    }
    return best.get();
}

}  // namespace coppice::inline v0
