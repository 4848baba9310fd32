#include "coppice/json/build_options.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace coppice::test {
namespace {

TEST(BuildOptionsJson, HasEveryOptionUnderItsName) {
    const BuildOptions options{
        .sample = {.rate = 0.25, .sampler = "uniform", .seed = 7, .uniform_share = 0.5},
        .split = {.rule = "median",
                  .max_depth = 20,
                  .max_leaf = 4,
                  .bad_refines = 2,
                  .clipping = Clipping::bounding_box,
                  .sample_weighting = SampleWeighting::expected,
                  .termination = Termination::sah,
                  .min_split = 3,
                  .max_duplication = 8},
        .leaf_refinement = LeafRefinement::none,
        .cost = {.traversal = 15, .intersection = 20, .empty_bonus = 0.2},
        .bvh8 = {.preset = Bvh8Preset::quality,
                 .expected_rays = 1e8,
                 .cell_size = 1024,
                 .sampled_from = 5000},
        .threads = 2};
    const nlohmann::json expected = {
        {"sample", {{"rate", 0.25}, {"sampler", "uniform"}, {"seed", 7}, {"uniform_share", 0.5}}},
        {"split",
         {{"rule", "median"},
          {"max_depth", 20},
          {"max_leaf", 4},
          {"bad_refines", 2},
          {"clipping", "bounding_box"},
          {"sample_weighting", "expected"},
          {"termination", "sah"},
          {"min_split", 3},
          {"max_duplication", 8}}},
        {"leaf_refinement", "none"},
        {"cost", {{"traversal", 15.0}, {"intersection", 20.0}, {"empty_bonus", 0.2}}},
        {"bvh8",
         {{"preset", "quality"},
          {"expected_rays", 1e8},
          {"cell_size", 1024},
          {"sampled_from", 5000}}},
        {"threads", 2}};
    EXPECT_EQ(nlohmann::json(options), expected);
}

}  // namespace
}  // namespace coppice::test
