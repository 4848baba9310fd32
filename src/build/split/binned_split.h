#pragma once

#include "coppice/build/split_finder.h"

namespace coppice {

/// A plane among the cheapest of all three axes: of bin boundaries in large nodes, then the best
/// fragment end near by; of all ends in small nodes.
class BinnedSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<Split> find(const SplitQuery& query) const override;
};

}  // namespace coppice
