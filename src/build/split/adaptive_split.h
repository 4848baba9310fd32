#pragma once

#include "coppice/build/split_finder.h"

namespace coppice {

/// The cheapest of 8 evenly spaced planes an axis and 8 where the counts change most; of all
/// fragment ends in small nodes.
class AdaptiveSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<Split> find(const SplitQuery& query) const override;
};

}  // namespace coppice
