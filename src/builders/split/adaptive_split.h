#pragma once

#include "coppice/builders/split_finder.h"

namespace coppice::inline v0 {

/// The rule "adaptive": the cheapest of 8 evenly spaced planes an axis and 8 planes where the
/// counts change most. In small nodes, the cheapest of all PrimRef ends.
class AdaptiveSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& query) const override;
};

}  // namespace coppice::inline v0
