#include "statistics/knee.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coppice::lab {

namespace {

struct Range {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();

    void grow(double value) {
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
    }

    // Halved before subtracting, so that a range of finite numbers never overflows.
    [[nodiscard]] double share(double value) const {
        const double extent = 0.5 * highest - 0.5 * lowest;
        return extent > 0.0 ? (0.5 * value - 0.5 * lowest) / extent : 0.0;
    }
};

bool is_usable(const KneePoint& point) {
    return std::isfinite(point.cost) && std::isfinite(point.time);
}

/// True if `a` is to be preferred to `b` where both save equally much per cost.
bool wins_tie(const KneePoint& a, const KneePoint& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.percent > b.percent;
}

}  // namespace

std::optional<KneePoint> find_knee(std::span<const KneePoint> curve) {
    Range costs;
    Range times;
    for (const KneePoint& point : curve) {
        if (!is_usable(point)) continue;
        costs.grow(point.cost);
        times.grow(point.time);
    }
    std::optional<KneePoint> knee;
    double knee_saving = 0.0;
    for (const KneePoint& point : curve) {
        if (!is_usable(point)) continue;
        // Time saved minus cost added, each as a share of its range: in [-1, 1].
        const double saving = (1.0 - times.share(point.time)) - costs.share(point.cost);
        const bool is_better =
            !knee || saving > knee_saving || (saving == knee_saving && wins_tie(point, *knee));
        if (!is_better) continue;
        knee = point;
        knee_saving = saving;
    }
    return knee;
}

}  // namespace coppice::lab
