// Collects the PrimRef ends in the bins around a boundary and sweeps them. The counts before them
// are known from the bins. If there are many ends, they are first counted in finer bins, and only
// those around the best finer boundary are swept. Cost: O(n), and a sort of few events.

#include "builders/split/snap.h"

#include "builders/split/axis_events.h"
#include "builders/split/evaluate_plane.h"

#include <algorithm>

namespace coppice::inline v0 {
namespace {

// Two neighbouring bins of an axis.
struct Window {
    Axis axis;
    float origin;
    float bins_per_unit;
    std::size_t first_bin;
    SplitCounts outside;       // weights that reach below and above the window
    double ends_within = 0.0;  // weight of the PrimRefs that end in the window

    // The window of the bins before and after a boundary. `beyond` holds the weights that reach
    // below and above all bins.
    Window(Axis on, float position, float scale, const AxisBins& bins, std::size_t boundary,
           const SplitCounts& beyond)
        : axis(on),
          origin(position),
          bins_per_unit(scale),
          first_bin(std::clamp<std::size_t>(boundary, 1, bin_count - 1) - 1),
          outside(beyond) {
        for (std::size_t bin = 0; bin < first_bin; ++bin) {
            outside.below += bins.starts[bin];
        }
        for (std::size_t bin = first_bin + 2; bin < bin_count; ++bin) {
            outside.above += bins.ends[bin];
        }
        ends_within = bins.ends[first_bin] + bins.ends[first_bin + 1];
    }

    [[nodiscard]] bool contains(float position) const noexcept {
        return bin_of(position, origin, bins_per_unit) - first_bin < 2;
    }
};

// Divides a window into 32 bins and returns the window of the two around the best boundary.
Window narrowed(const Window& window, const SplitQuery& query, const PlaneEvaluator& evaluator) {
    constexpr std::size_t bins_of_each = bin_count / 2;
    constexpr auto finer = static_cast<float>(bins_of_each);
    const float origin =
        static_cast<float>(window.first_bin) / window.bins_per_unit + window.origin;
    const float bins_per_unit = finer * window.bins_per_unit;
    AxisBins bins;
    for (const PrimRef& prim_ref : query.prim_refs) {
        const float start = prim_ref.box.lower[window.axis];
        const float end = prim_ref.box.upper[window.axis];
        if (window.contains(start)) {
            bins.add_start(bin_of(start, origin, bins_per_unit), start, prim_ref.weight);
        }
        if (window.contains(end)) {
            bins.add_end(bin_of(end, origin, bins_per_unit), end, prim_ref.weight);
        }
    }
    const std::size_t boundary = best_end(bins, window.outside, evaluator).bin;
    return {window.axis, origin, bins_per_unit, bins, boundary, window.outside};
}

// Offers the splits at all ends for which `is_near` is true, and which are in the window.
template <typename IsNear>
void sweep_window(const SplitQuery& query, const Window& window, const PlaneEvaluator& evaluator,
                  IsNear&& is_near, BestSplit& best) {
    AxisEvents events;
    for (const PrimRef& prim_ref : query.prim_refs) {
        const bool starts = is_near(prim_ref.box.lower[window.axis]);
        const bool ends = is_near(prim_ref.box.upper[window.axis]);
        if (starts || ends) events.add(prim_ref, window.axis, starts, ends);
    }
    const SplitCounts& outside = window.outside;
    sweep_events(events, evaluator, {outside.below, outside.above + window.ends_within, 0.0}, best);
}

}  // namespace

SplitCandidate snap(const SplitQuery& query, const BinGrid& grid, const AxisBins& bins,
                    const BinnedPlane& coarse) {
    constexpr std::size_t many = 8192;
    const Axis axis = coarse.split.plane.axis;
    const PlaneEvaluator evaluator(query.box, axis, query.cost);
    const Window window(axis, grid.origin[axis], grid.bins_per_unit[axis], bins, coarse.bin, {});
    const auto is_near = [&](float position) { return window.contains(position); };
    BestSplit best;
    best.offer(coarse.split);
    if (query.prim_refs.size() < many) {
        sweep_window(query, window, evaluator, is_near, best);
    } else {
        const Window fine = narrowed(window, query, evaluator);
        const auto is_nearer = [&](float position) {
            return is_near(position) && fine.contains(position);
        };
        sweep_window(query, fine, evaluator, is_nearer, best);
    }
    return *best.get();
}

}  // namespace coppice::inline v0
