#include "rows/recommend.h"

#include <fmt/format.h>

#include <algorithm>

namespace coppice::lab {

namespace {

/// The summaries of one kind, protocol and sampler.
struct Curve {
    std::vector<const RateSummary*> summaries;

    [[nodiscard]] const RateSummary& first() const { return *summaries.front(); }

    /// Whether there is nothing to choose from.
    [[nodiscard]] bool has_full_only() const {
        return summaries.size() == 1 && first().sample_percent == 100.0;
    }
};

std::vector<Curve> curves_of(std::span<const RateSummary> summaries) {
    std::vector<Curve> curves;
    for (const RateSummary& summary : summaries) {
        const auto at = std::find_if(curves.begin(), curves.end(), [&](const Curve& curve) {
            return curve.first().primitives == summary.primitives &&
                   curve.first().protocol == summary.protocol &&
                   curve.first().sampler == summary.sampler;
        });
        if (at == curves.end()) {
            curves.push_back({{&summary}});
        } else {
            at->summaries.push_back(&summary);
        }
    }
    return curves;
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
    for (const Curve& curve : curves_of(summaries)) {
        if (curve.first().sampler.empty() || curve.has_full_only()) continue;
        const RateSummary* smallest = nullptr;
        for (const RateSummary* summary : curve.summaries) {
            const bool is_smaller =
                smallest == nullptr || summary->sample_percent < smallest->sample_percent;
            if (is_smaller && is_within(*summary, tolerance)) smallest = summary;
        }
        if (smallest == nullptr) continue;
        recommended.push_back({smallest->primitives, smallest->protocol, smallest->sampler,
                               point_of(*smallest), smallest->relative_time.interval});
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
    for (const Curve& curve : curves_of(summaries)) {
        if (curve.first().sampler.empty() || curve.summaries.size() < 2) continue;
        std::vector<KneePoint> points;
        for (const RateSummary* summary : curve.summaries) {
            points.push_back(point_of(*summary));
        }
        if (const auto knee = find_knee(points)) {
            const RateSummary& first = curve.first();
            knees.push_back({first.primitives, first.protocol, first.sampler, *knee, {}});
        }
    }
    return knees;
}

}  // namespace coppice::lab
