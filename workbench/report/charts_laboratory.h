#pragma once

#include "report/series.h"

#include <nlohmann/json.hpp>

#include <string_view>

namespace coppice::report {

// Every function here returns a Vega-Lite specification with its data inside, or null where the
// results have no data for it. `scene` is one of the results' scenes.

/// SAH cost against the measured time of a ray, a point for each tree of one form ("kd", "bvh8"):
/// those of different forms cannot be compared.
[[nodiscard]] nlohmann::json make_cost_ray_chart(const nlohmann::json& scene,
                                                 std::string_view form);

/// Seconds until so many rays are traced, building included, against their number: a line for each
/// tree, the fastest ones drawn over the others where they are.
[[nodiscard]] nlohmann::json make_image_time_chart(const nlohmann::json& scene);

/// What the trees of one line cost beyond the full tree, by cause, stacked, for each percentage.
[[nodiscard]] nlohmann::json make_decomposition_chart(const nlohmann::json& scene,
                                                      const Series& series, std::string_view line);

/// Two trees to look at side by side: the full one, and the one that is recommended or, where that
/// is the full one or none is, the smallest sample's.
struct TreePairPoints {
    const RatePoint* full = nullptr;
    const RatePoint* sampled = nullptr;
};

/// The pair of the last protocol that has one with costs by level, by the usual sampler if there is
/// one; null pointers if none has.
[[nodiscard]] TreePairPoints find_tree_pair(const Series& series);

/// The cost at each level of both trees of find_tree_pair().
[[nodiscard]] nlohmann::json make_pair_level_chart(const Series& series);

}  // namespace coppice::report
