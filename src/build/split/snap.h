#pragma once

#include "coppice/build/split_finder.h"

#include "build/split/best_split.h"
#include "build/split/node_bins.h"

namespace coppice {

/// The boundary before a bin of an axis.
struct BinBoundary {
    Axis axis;
    std::size_t bin;  ///< in [1, bin_count)
};

/// Offers the cheapest split at a fragment end in the bins on both sides of a boundary.
void snap(const SplitQuery& query, const BinGrid& grid, const AxisBins& bins, BinBoundary boundary,
          BestSplit& best);

}  // namespace coppice
