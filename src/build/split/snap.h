#pragma once

#include "coppice/build/split_finder.h"

#include "build/split/node_bins.h"

namespace coppice {

/// The cheapest split near the one that best_end() found in the bins of a whole axis.
[[nodiscard]] Split snap(const SplitQuery& query, const BinGrid& grid, const AxisBins& bins,
                         const BinnedPlane& coarse);

}  // namespace coppice
