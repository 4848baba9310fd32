#pragma once

#include "coppice/base/cpu.h"

#include "builders/kernels/bin_ends.h"
#include "builders/kernels/plane_costs.h"

#include <span>

namespace coppice::inline v0 {

/// The inner loops of the k-d builders, compiled for one instruction set. All sets give the same
/// results to the bit.
struct KdKernels {
    /// Evaluates the ends strictly inside the node. Costs are, bit for bit, those of
    /// PlaneEvaluator.
    BestPlane (*find_best_plane)(const AxisEnds&, const CostTerms&) noexcept;

    /// Adds PrimRefs to the bins.
    void (*bin_ends)(std::span<const PrimRef>, const BinGrid&, NodeBins&) noexcept;
};

/// The kernels for an instruction set that this processor has.
[[nodiscard]] const KdKernels& kd_kernels_for(Isa isa) noexcept;

}  // namespace coppice::inline v0
