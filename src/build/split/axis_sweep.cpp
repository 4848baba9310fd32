#include "build/split/axis_sweep.h"

#include "build/split/axis_events.h"

namespace coppice {

std::optional<Split> sweep_axis(const SplitQuery& query, Axis axis) {
    AxisEvents events;
    events.starts.reserve(query.fragments.size());
    events.ends.reserve(query.fragments.size());
    for (const Fragment& fragment : query.fragments) {
        events.add(fragment, axis);
    }
    BestSplit best;
    sweep_events(events, PlaneEvaluator(query.box, axis, query.cost),
                 {0.0, weight_of(query.fragments), 0.0}, best);
    return best.get();
}

}  // namespace coppice
