#pragma once

#include "coppice/base/cpu.h"

#include "builders/kernels/bin_ends.h"
#include "builders/kernels/plane_costs.h"

#include <span>

namespace coppice::inline v0 {

/// The inner loops of the k-d builders for one instruction set. All sets give equal results to the
/// bit.
struct KdKernels {
    /// Finds the cheapest plane among the ends strictly inside the node. Costs equal those of
    /// PlaneEvaluator to the bit.
    BestPlane (*find_best_plane)(const AxisEnds&, const CostTerms&) noexcept;

    /// Adds the ends of PrimRefs to the bins.
    void (*bin_ends)(std::span<const PrimRef>, const BinGrid&, NodeBins&) noexcept;
};

/// The kernels for an instruction set, which this processor must support.
[[nodiscard]] const KdKernels& kd_kernels_for(Isa isa) noexcept;

}  // namespace coppice::inline v0
