#pragma once

#include "coppice/builders/split_finder.h"

namespace coppice::inline v0 {

/// The rule "midpoint": the plane through the middle of the node on its longest axis.
class MidpointSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& query) const override;
};

}  // namespace coppice::inline v0
