#pragma once

#include "coppice/build/split_finder.h"

namespace coppice {

/// The plane through the median of the fragments' centers, on the longest axis that has one inside.
class MedianSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<Split> find(const SplitQuery& query) const override;
};

}  // namespace coppice
