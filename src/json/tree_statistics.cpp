#include "coppice/json/tree_statistics.h"

#include <nlohmann/json.hpp>

namespace coppice::inline v0 {

void to_json(nlohmann::json& json, const TreeStatistics& statistics) {
    json = {{"node_count", statistics.node_count},
            {"inner_count", statistics.inner_count},
            {"leaf_count", statistics.leaf_count},
            {"single_primitive_leaf_count", statistics.single_primitive_leaf_count},
            {"empty_leaf_count", statistics.empty_leaf_count},
            {"reference_count", statistics.reference_count},
            {"max_level", statistics.max_level},
            {"mean_leaf_size", statistics.mean_leaf_size},
            {"sah_cost", statistics.sah_cost},
            {"expected_inner_visits", statistics.expected_inner_visits},
            {"expected_leaf_visits", statistics.expected_leaf_visits},
            {"expected_primitive_tests", statistics.expected_primitive_tests},
            {"depth_histogram", statistics.depth_histogram},
            {"cost_share_by_depth", statistics.cost_share_by_depth}};
}

}  // namespace coppice::inline v0
