#pragma once

#include "coppice/builders/split_finder.h"

namespace coppice::inline v0 {

/// A plane among the cheapest of all three axes: of bin boundaries in large nodes, then the best
/// PrimRef end near by; of all ends in small nodes.
class BinnedSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& query) const override;

    [[nodiscard]] bool allows_loose_small_nodes() const noexcept override { return true; }
};

}  // namespace coppice::inline v0
