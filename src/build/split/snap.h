#pragma once

#include "coppice/build/split_finder.h"

#include "build/split/best_split.h"
#include "build/split/node_bins.h"

namespace coppice {

/// Offers the cheapest split at a fragment end in the bins on both sides of a boundary.
void snap(const SplitQuery& query, const BinGrid& grid, const AxisBins& bins,
          const BinBoundary& boundary, BestSplit& best);

}  // namespace coppice
