#pragma once

#include "coppice/build/split_finder.h"

namespace coppice {

/// The cheapest bin boundary of all three axes as a part of the node's fragments sees it, priced
/// with all of them; of all fragment ends in small nodes.
class SubsampledSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<Split> find(const SplitQuery& query) const override;
};

}  // namespace coppice
