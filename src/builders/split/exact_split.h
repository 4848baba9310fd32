#pragma once

#include "coppice/builders/split_finder.h"

namespace coppice::inline v0 {

/// The rule "exact": the cheapest plane of all three axes; of equal ones the first by axis, then by
/// position.
class ExactSplit final : public SplitFinder {
public:
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& query) const override;

    [[nodiscard]] bool finds_cheapest_end() const noexcept override { return true; }
};

}  // namespace coppice::inline v0
