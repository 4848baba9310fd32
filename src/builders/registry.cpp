#include "coppice/base/named.h"
#include "coppice/builders/split_finder.h"

#include "builders/split/adaptive_split.h"
#include "builders/split/binned_split.h"
#include "builders/split/exact_split.h"
#include "builders/split/median_split.h"
#include "builders/split/midpoint_split.h"
#include "builders/split/sah_sweep.h"
#include "builders/split/subsampled_split.h"

#include <array>

namespace coppice::inline v0 {

std::span<const SplitFinderEntry> split_finder_registry() {
    static const SahSweep sah;
    static const MedianSplit median;
    static const MidpointSplit midpoint;
    static const ExactSplit exact;
    static const BinnedSplit binned;
    static const SubsampledSplit subsampled;
    static const AdaptiveSplit adaptive;
    static const std::array entries{
        SplitFinderEntry{"sah", "cheapest plane by the surface area heuristic, longest axis first",
                         sah},
        SplitFinderEntry{"median", "plane through the median of the centers on the longest axis",
                         median},
        SplitFinderEntry{"midpoint", "plane through the middle of the node's longest axis",
                         midpoint},
        SplitFinderEntry{"exact", "cheapest plane by the surface area heuristic on any axis",
                         exact},
        SplitFinderEntry{"binned", "as exact in small nodes, else the best end near the best bin",
                         binned},
        SplitFinderEntry{"subsampled", "as binned, from 1024 PrimRefs of the node, bins only",
                         subsampled},
        SplitFinderEntry{"adaptive", "8 even planes an axis and 8 where the counts change most",
                         adaptive},
    };
    return entries;
}

const SplitFinder& find_split_finder(std::string_view name) {
    return find_named(split_finder_registry(), name, "split rule").finder;
}

const SplitFinder& split_finder_of(const SplitOptions& options) {
    return options.custom_rule ? *options.custom_rule : find_split_finder(options.rule);
}

}  // namespace coppice::inline v0
