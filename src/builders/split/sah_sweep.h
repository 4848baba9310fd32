#pragma once

#include "coppice/builders/split_finder.h"

namespace coppice::inline v0 {

/// The rule "sah": the cheapest plane among all PrimRef ends on the longest axis; on another axis
/// only if that has none.
class SahSweep final : public SplitFinder {
public:
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& query) const override;
};

}  // namespace coppice::inline v0
