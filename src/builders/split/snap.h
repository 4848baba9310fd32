#pragma once

#include "coppice/builders/split_finder.h"

#include "builders/split/node_bins.h"

namespace coppice::inline v0 {

/// The cheapest split near the one that best_end() found in the bins of an axis.
[[nodiscard]] SplitCandidate snap(const SplitQuery& query, const BinGrid& grid,
                                  const AxisBins& bins, const BinnedPlane& coarse);

}  // namespace coppice::inline v0
