#include "coppice/json/build_options.h"

#include "coppice/builders/split_finder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace coppice::test {
namespace {

TEST(KdOptions, AreSerializedUnderTheirNames) {
    const KdOptions options{
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
        {"threads", 2}};
    EXPECT_EQ(nlohmann::json(options), expected);
    EXPECT_EQ(nlohmann::json(BuildOptions(options)), expected);
}

TEST(Bvh8Options, AreSerializedUnderTheirNames) {
    const Bvh8Options options{.sample = {.rate = 0.25, .sampler = "weighted", .seed = 7},
                              .preset = Bvh8Preset::quality,
                              .expected_rays = 1e8,
                              .cell_size = 1024,
                              .sampled_from = 5000,
                              .cost = {.traversal = 15, .intersection = 20, .empty_bonus = 0.2},
                              .threads = 2};
    const nlohmann::json expected = {
        {"sample", {{"rate", 0.25}, {"sampler", "weighted"}, {"seed", 7}, {"uniform_share", 0.5}}},
        {"preset", "quality"},
        {"expected_rays", 1e8},
        {"cell_size", 1024},
        {"sampled_from", 5000},
        {"cost", {{"traversal", 15.0}, {"intersection", 20.0}, {"empty_bonus", 0.2}}},
        {"threads", 2}};
    EXPECT_EQ(nlohmann::json(options), expected);
    EXPECT_EQ(nlohmann::json(BuildOptions(options)), expected);
}

class NoSplit final : public SplitFinder {
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& /*query*/) const override {
        return std::nullopt;
    }
};

TEST(KdOptions, OfYourOwnAreCustom) {
    KdOptions options;
    options.split.custom_rule = std::make_shared<NoSplit>();
    EXPECT_EQ(nlohmann::json(options)["split"]["rule"], "custom");
}

}  // namespace
}  // namespace coppice::test
