#pragma once

#include "rows/results.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coppice::lab {

/// Where the cost of a sampled tree comes from that the full tree of the same seed has not. All
/// parts are shares of the full tree's cost, of either sign, and add up to `excess`.
struct CostParts : TreeKey {
    double excess = 0.0;         ///< relative cost - 1
    double early_stop = 0.0;     ///< leaves so large because the limit counts sampled primitives
    double empty_cells = 0.0;    ///< tests in cells empty in the sample but not in the scene
    double duplicates = 0.0;     ///< tests of references beyond the first of each primitive
    double plane_error = 0.0;    ///< planes that are worse than those of all primitives
    double uneven_leaves = 0.0;  ///< what remains: leaves that the sample judged wrongly
};

/// The parts of each row below 100 % by the protocols `fixed`, `scaled` and `grown`, in the order
/// of the rows of one scene. They are differences between the three trees of the same sample and
/// the three full trees (docs/experiment.md): nothing for rows for which one of these is missing; a
/// `grown` row needs only its own full tree.
[[nodiscard]] std::vector<CostParts> decompose_costs(std::span<const ResultRow> rows);

}  // namespace coppice::lab
