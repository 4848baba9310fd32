#pragma once

#include "coppice/builders/split_finder.h"

namespace coppice::inline v0 {

/// The plane of least cost among all PrimRef ends, on the longest axis; on the others if that
/// axis has none to offer.
class SahSweep final : public SplitFinder {
public:
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& query) const override;
};

}  // namespace coppice::inline v0
