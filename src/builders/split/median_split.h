#pragma once

#include "coppice/builders/split_finder.h"

namespace coppice::inline v0 {

/// The rule "median": the plane through the median of the PrimRefs' centers, on the longest axis
/// where that is inside the node.
class MedianSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& query) const override;
};

}  // namespace coppice::inline v0
