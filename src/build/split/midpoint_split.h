#pragma once

#include "coppice/build/split_finder.h"

namespace coppice {

/// The plane through the middle of the node, on its longest axis.
class MidpointSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<Split> find(const SplitQuery& query) const override;
};

}  // namespace coppice
