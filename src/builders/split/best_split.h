#pragma once

#include "coppice/builders/split_finder.h"

#include <limits>
#include <optional>

namespace coppice::inline v0 {

/// Keeps the cheapest of the offered splits; of equal ones the first by axis, then by position. So
/// the result does not depend on the order of offers.
class BestSplit {
public:
    void offer(const SplitCandidate& split) noexcept {
        if (!best_ || is_before(split, *best_)) best_ = split;
    }

    /// The cost of the cheapest split; infinite if there is none.
    [[nodiscard]] double cost() const noexcept {
        return best_ ? best_->cost : std::numeric_limits<double>::infinity();
    }

    [[nodiscard]] const std::optional<SplitCandidate>& get() const noexcept { return best_; }

private:
    static bool is_before(const SplitCandidate& a, const SplitCandidate& b) noexcept {
        if (a.cost != b.cost) return a.cost < b.cost;
        if (a.plane.axis != b.plane.axis) return a.plane.axis < b.plane.axis;
        return a.plane.position < b.plane.position;
    }

    std::optional<SplitCandidate> best_;
};

}  // namespace coppice::inline v0
