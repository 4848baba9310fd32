#pragma once

#include "coppice/build/split_finder.h"

namespace coppice {

/// The cheapest plane of all three axes; of equal ones the first by axis, then by position.
class ExactSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<Split> find(const SplitQuery& query) const override;
};

}  // namespace coppice
