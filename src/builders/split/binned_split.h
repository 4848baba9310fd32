#pragma once

#include "coppice/builders/split_finder.h"

namespace coppice::inline v0 {

/// The rule "binned": in large nodes, the cheapest bin boundary of all three axes, moved to the
/// best PrimRef end nearby. In small nodes, the cheapest of all PrimRef ends.
class BinnedSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& query) const override;

    [[nodiscard]] bool allows_loose_small_nodes() const noexcept override { return true; }
};

}  // namespace coppice::inline v0
