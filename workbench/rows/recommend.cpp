#include "rows/recommend.h"

#include "rows/group_by.h"

#include <fmt/format.h>

#include <algorithm>

namespace coppice::lab {

namespace {

/// The summaries of each series: its curve.
std::vector<Group<RateSummary>> curves_of(std::span<const RateSummary> summaries) {
    return group_by(summaries, [](const RateSummary& a, const RateSummary& b) {
        return a.series() == b.series();
    });
}

/// Whether there is nothing to choose from.
bool has_full_only(const Group<RateSummary>& curve) {
    return curve.size() == 1 && curve.front()->sample_percent == 100.0;
}

KneePoint point_of(const RateSummary& summary) {
    return {summary.sample_percent, summary.relative_cost.mean, summary.relative_time.mean};
}

/// False for a cost that is not finite.
bool is_within(const RateSummary& summary, double tolerance) {
    const SeedMean& cost = summary.relative_cost;
    return (cost.interval ? cost.interval->high : cost.mean) <= 1.0 + tolerance;
}

}  // namespace

std::vector<Recommendation> recommend(std::span<const RateSummary> summaries, double tolerance) {
    std::vector<Recommendation> recommended;
    for (const Group<RateSummary>& curve : curves_of(summaries)) {
        if (curve.front()->sampler.empty() || has_full_only(curve)) continue;
        const RateSummary* smallest = nullptr;
        for (const RateSummary* summary : curve) {
            const bool is_smaller =
                smallest == nullptr || summary->sample_percent < smallest->sample_percent;
            if (is_smaller && is_within(*summary, tolerance)) smallest = summary;
        }
        if (smallest == nullptr) continue;
        recommended.push_back(
            {smallest->series(), point_of(*smallest), smallest->relative_time.interval});
    }
    return recommended;
}

std::string recommendation_rule(double tolerance, int seed_count) {
    return fmt::format("the smallest sample whose cost is within {:.3g} % of the full tree's, {}",
                       100.0 * tolerance,
                       seed_count > 1 ? fmt::format("with 95 % confidence ({}, {} seeds)",
                                                    interval_name, seed_count)
                                      : "of one seed (no interval: see --seeds)");
}

std::vector<Recommendation> find_knees(std::span<const RateSummary> summaries) {
    std::vector<Recommendation> knees;
    for (const Group<RateSummary>& curve : curves_of(summaries)) {
        if (curve.front()->sampler.empty() || curve.size() < 2) continue;
        std::vector<KneePoint> points;
        for (const RateSummary* summary : curve) {
            points.push_back(point_of(*summary));
        }
        if (const auto knee = find_knee(points)) {
            knees.push_back({curve.front()->series(), *knee, {}});
        }
    }
    return knees;
}

}  // namespace coppice::lab
