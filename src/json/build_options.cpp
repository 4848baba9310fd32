#include "coppice/json/build_options.h"

#include "coppice/json/sah_cost_model.h"

#include <nlohmann/json.hpp>

namespace coppice::inline v0 {

void to_json(nlohmann::json& json, const SampleOptions& options) {
    json = {{"rate", options.rate},
            {"sampler", options.custom_sampler ? "custom" : options.sampler},
            {"seed", options.seed},
            {"uniform_share", options.uniform_share}};
}

void to_json(nlohmann::json& json, const KdOptions& options) {
    const SplitOptions& split = options.split;
    json = {{"sample", options.sample},
            {"split",
             {{"rule", split.custom_rule ? "custom" : split.rule},
              {"max_depth", split.max_depth},
              {"max_leaf", split.max_leaf},
              {"bad_refines", split.bad_refines},
              {"clipping", name_of(split.clipping)},
              {"sample_weighting", name_of(split.sample_weighting)},
              {"termination", name_of(split.termination)},
              {"min_split", split.min_split},
              {"max_duplication", split.max_duplication}}},
            {"leaf_refinement", name_of(options.leaf_refinement)},
            {"cost", options.cost},
            {"threads", options.threads}};
}

void to_json(nlohmann::json& json, const Bvh8Options& options) {
    json = {{"sample", options.sample},
            {"preset", name_of(options.preset)},
            {"expected_rays", options.expected_rays},
            {"cell_size", options.cell_size},
            {"sampled_from", options.sampled_from},
            {"cost", options.cost},
            {"threads", options.threads}};
}

void to_json(nlohmann::json& json, const BuildOptions& options) {
    std::visit([&](const auto& of) { to_json(json, of); }, options);
}

}  // namespace coppice::inline v0
