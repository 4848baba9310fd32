#pragma once

#include "coppice/builders/split_finder.h"

namespace coppice::inline v0 {

/// The cheapest bin boundary of all three axes as a part of the node's PrimRefs sees it, priced
/// with all of them; of all PrimRef ends in small nodes.
class SubsampledSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& query) const override;
};

}  // namespace coppice::inline v0
