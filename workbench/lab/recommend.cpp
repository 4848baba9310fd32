#include "lab/recommend.h"

#include <algorithm>

namespace coppice::lab {

namespace {

/// The curve of one kind and protocol, with sums over the seeds so far.
struct Curve {
    std::string primitives;
    std::string protocol;
    std::vector<KneePoint> sums;
    std::vector<int> seed_counts;  // aligned with `sums`

    void add(const ResultRow& row) {
        const auto same = [&](const KneePoint& sum) { return sum.percent == row.sample_percent; };
        const auto at = std::find_if(sums.begin(), sums.end(), same);
        if (at == sums.end()) {
            sums.push_back({row.sample_percent, row.relative_cost, row.relative_time});
            seed_counts.push_back(1);
            return;
        }
        at->cost += row.relative_cost;
        at->time += row.relative_time;
        ++seed_counts[static_cast<std::size_t>(at - sums.begin())];
    }

    [[nodiscard]] std::vector<KneePoint> means() const {
        std::vector<KneePoint> means = sums;
        for (std::size_t i = 0; i < means.size(); ++i) {
            means[i].cost /= seed_counts[i];
            means[i].time /= seed_counts[i];
        }
        return means;
    }
};

}  // namespace

std::vector<Recommendation> recommend(std::span<const ResultRow> rows) {
    std::vector<Curve> curves;
    for (const ResultRow& row : rows) {
        const auto same = [&](const Curve& curve) {
            return curve.primitives == row.primitives && curve.protocol == row.protocol;
        };
        auto at = std::find_if(curves.begin(), curves.end(), same);
        if (at == curves.end()) at = curves.insert(at, {row.primitives, row.protocol, {}, {}});
        at->add(row);
    }
    std::vector<Recommendation> recommended;
    for (const Curve& curve : curves) {
        if (const auto knee = find_knee(curve.means())) {
            recommended.push_back({curve.primitives, curve.protocol, *knee});
        }
    }
    return recommended;
}

}  // namespace coppice::lab
