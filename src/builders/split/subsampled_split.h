#pragma once

#include "coppice/builders/split_finder.h"

namespace coppice::inline v0 {

/// The rule "subsampled": in large nodes, the cheapest bin boundary of all three axes for a part of
/// the PrimRefs, with its cost computed for all of them. In small nodes, the cheapest of all
/// PrimRef ends.
class SubsampledSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& query) const override;
};

}  // namespace coppice::inline v0
