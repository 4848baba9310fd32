#pragma once

#include "coppice/build/split_finder.h"

namespace coppice {

/// The plane of least cost among all fragment ends, on the longest axis; on the others if that
/// axis has none to offer.
class SahSweep final : public SplitFinder {
public:
    [[nodiscard]] std::optional<Split> find(const SplitQuery& query) const override;
};

}  // namespace coppice
