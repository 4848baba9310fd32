#pragma once

#include "coppice/builders/split_finder.h"

namespace coppice::inline v0 {

/// The plane through the median of the PrimRefs' centers, on the longest axis that has one inside.
class MedianSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& query) const override;
};

}  // namespace coppice::inline v0
