#include "coppice/json/build_options.h"

#include "coppice/json/sah_cost_model.h"

#include <nlohmann/json.hpp>

namespace coppice::inline v0 {

void to_json(nlohmann::json& json, const BuildOptions& options) {
    json = {{"sample",
             {{"rate", options.sample.rate},
              {"sampler", options.sample.sampler},
              {"seed", options.sample.seed},
              {"uniform_share", options.sample.uniform_share}}},
            {"split",
             {{"rule", options.split.rule},
              {"max_depth", options.split.max_depth},
              {"max_leaf", options.split.max_leaf},
              {"bad_refines", options.split.bad_refines},
              {"clipping", name_of(options.split.clipping)},
              {"sample_weighting", name_of(options.split.sample_weighting)},
              {"termination", name_of(options.split.termination)},
              {"min_split", options.split.min_split},
              {"max_duplication", options.split.max_duplication}}},
            {"leaf_refinement", name_of(options.leaf_refinement)},
            {"cost", options.cost},
            {"bvh8",
             {{"preset", name_of(options.bvh8.preset)},
              {"expected_rays", options.bvh8.expected_rays},
              {"cell_size", options.bvh8.cell_size},
              {"sampled_from", options.bvh8.sampled_from}}},
            {"threads", options.threads}};
}

}  // namespace coppice::inline v0
