#pragma once

#include "coppice/builders/split_finder.h"

namespace coppice::inline v0 {

/// The cheapest of 8 evenly spaced planes an axis and 8 where the counts change most; of all
/// PrimRef ends in small nodes.
class AdaptiveSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& query) const override;
};

}  // namespace coppice::inline v0
