#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace coppice::lab {

/// The rule by which find_knee() chooses, and where it comes from; recorded in every result.
inline constexpr std::string_view knee_rule = "kneedle";
inline constexpr std::string_view knee_source =
    "V. Satopaa, J. Albrecht, D. Irwin, B. Raghavan: Finding a \"Kneedle\" in a Haystack: "
    "Detecting "
    "Knee Points in System Behavior. ICDCS Workshops 2011";

/// A point of the cost-against-time curve: one sample percentage, its cost and its time, both in
/// any unit, or relative to the full tree's.
struct KneePoint {
    double percent = 100.0;
    double cost = 1.0;
    double time = 1.0;
};

/// The point with the greatest saving per cost, by the Kneedle rule: costs and times are
/// normalised to [0, 1] over the curve, and the point with the greatest difference between the
/// share of the time that it saves and the share of the cost that it adds is the knee.
/// - The chosen point is on the lower hull of the curve: no other is both faster and cheaper.
/// - Equal costs: the fastest point. Equal times: the cheapest. One point: that.
/// - A tie goes to the lower cost, then to the larger percentage.
/// - Points with a cost or time that is not finite are passed over; nothing is left: nothing.
/// Source: [Satopaa2011] sec. III, with neither the smoothing spline (a dozen measured points) nor
/// the sensitivity threshold (the whole curve is known: the greatest maximum is taken).
[[nodiscard]] std::optional<KneePoint> find_knee(std::span<const KneePoint> curve);

}  // namespace coppice::lab
