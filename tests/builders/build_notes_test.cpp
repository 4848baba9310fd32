// An option that was asked for and has no effect stands in the report with the reason.

#include "coppice/builders/build_report.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"
#include "coppice/builders/split_finder.h"

#include "support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace coppice::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint32_t many = 1'000'000;
constexpr std::uint32_t few = 1'000;

template <typename Options>
std::vector<std::string> noted(const Options& options, std::uint32_t primitive_count = many) {
    std::vector<std::string> names;
    for (const BuildNote& note : notes_on(options, primitive_count)) {
        EXPECT_FALSE(note.reason.empty()) << note.option;
        names.push_back(note.option);
    }
    return names;
}

class FirstOnes final : public Sampler {
    [[nodiscard]] Sample draw(PrimitiveSetView /*primitives*/, std::uint32_t count,
                              const SampleOptions& options) const override {
        Sample sample{{}, {}, options};
        for (std::uint32_t id = 0; id < count; ++id) {
            sample.ids.push_back(id);
        }
        return sample;
    }
};

class NoSplit final : public SplitFinder {
    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& /*query*/) const override {
        return std::nullopt;
    }
};

class UnitCost final : public CostModel {
    [[nodiscard]] double traversal_cost() const noexcept override { return 1.0; }

    [[nodiscard]] double leaf_cost(double count) const noexcept override { return count; }
};

TEST(KdNotes, OnNothingByDefault) {
    EXPECT_THAT(noted(KdOptions{}), IsEmpty());
    EXPECT_THAT(noted(KdOptions{.sample = {.rate = 0.1, .sampler = "weighted", .seed = 7}}),
                IsEmpty());
    EXPECT_THAT(noted(KdOptions{}, 0), IsEmpty());
}

TEST(KdNotes, OnASampleThatIsNotDrawn) {
    EXPECT_THAT(
        noted(KdOptions{.sample = {.sampler = "weighted", .seed = 7, .uniform_share = 0.1}}),
        ElementsAre("sample.sampler", "sample.seed", "sample.uniform_share"));
    EXPECT_THAT(noted(KdOptions{.sample = {.custom_sampler = std::make_shared<FirstOnes>()}}),
                ElementsAre("sample.custom_sampler"));
    EXPECT_THAT(noted(KdOptions{.sample = {.rate = 0.9}}, 1), ElementsAre("sample.rate"));
    EXPECT_THAT(noted(KdOptions{.split = {.sample_weighting = SampleWeighting::expected}}),
                ElementsAre("split.sample_weighting"));
}

TEST(KdNotes, OnASamplerThatHasNoUseForIt) {
    EXPECT_THAT(noted(KdOptions{.sample = {.rate = 0.1, .uniform_share = 0.1}}),
                ElementsAre("sample.uniform_share"));
    EXPECT_THAT(
        noted(KdOptions{.sample = {.rate = 0.1, .sampler = "weighted", .uniform_share = 0.1}}),
        IsEmpty());
    EXPECT_THAT(noted(KdOptions{.sample = {.rate = 0.1,
                                           .sampler = "weighted",
                                           .uniform_share = 0.1,
                                           .custom_sampler = std::make_shared<FirstOnes>()}}),
                ElementsAre("sample.sampler"));
}

TEST(KdNotes, OnLimitsThatLimitNothing) {
    EXPECT_THAT(noted(KdOptions{.split = {.max_leaf = 4,
                                          .bad_refines = 1,
                                          .termination = Termination::sah,
                                          .min_split = 2}}),
                ElementsAre("split.max_leaf", "split.bad_refines"));
    EXPECT_THAT(noted(KdOptions{.split = {.max_leaf = 4, .min_split = 2, .max_duplication = 3},
                                .leaf_refinement = LeafRefinement::none}),
                ElementsAre("split.min_split", "split.max_duplication"));
    EXPECT_THAT(noted(KdOptions{.split = {.max_leaf = 4, .min_split = 2, .max_duplication = 3}}),
                IsEmpty());
}

TEST(KdNotes, OnWhatAnObjectOfOnesOwnReplaces) {
    const KdOptions options{
        .split = {.rule = "median", .custom_rule = std::make_shared<NoSplit>()},
        .cost = {.traversal = 2.0, .empty_bonus = 0.1, .custom = std::make_shared<UnitCost>()}};
    EXPECT_THAT(noted(options), ElementsAre("split.rule", "cost.traversal", "cost.empty_bonus"));
}

TEST(Bvh8Notes, OnNothingByDefault) {
    EXPECT_THAT(noted(Bvh8Options{}), IsEmpty());
    EXPECT_THAT(noted(Bvh8Options{}, few), IsEmpty());
    EXPECT_THAT(noted(Bvh8Options{.sample = {.rate = 0.05, .seed = 3}, .cell_size = 64}),
                IsEmpty());
}

TEST(Bvh8Notes, OnACrossoverThatTheSceneIsBelow) {
    const auto notes = notes_on(Bvh8Options{.sample = {.rate = 0.05, .seed = 3}}, few);
    ASSERT_EQ(notes.size(), 2U);
    EXPECT_EQ(notes[0], (BuildNote{"sample.rate",
                                   "the scene has 1000 triangles; scenes of fewer than "
                                   "200000 are not sampled (sampled_from)"}));
    EXPECT_EQ(notes[1].option, "sample.seed");
    EXPECT_THAT(noted(Bvh8Options{.cell_size = 64}, few), ElementsAre("cell_size"));
    EXPECT_THAT(noted(Bvh8Options{.preset = Bvh8Preset::balanced, .cell_size = 64}, few), IsEmpty())
        << "cells by planes there are without a sample, too";
}

TEST(Bvh8Notes, OnWhatThePresetDoesNotGoBy) {
    EXPECT_THAT(noted(Bvh8Options{.preset = Bvh8Preset::fast, .expected_rays = 1e9}),
                ElementsAre("expected_rays"));
    EXPECT_THAT(noted(Bvh8Options{.preset = Bvh8Preset::fast, .sampled_from = 5}),
                ElementsAre("sampled_from"));
    EXPECT_THAT(noted(Bvh8Options{.sample = {.sampler = "stratified"}}),
                ElementsAre("sample.sampler"))
        << "automatic draws a sample of its own";
    EXPECT_THAT(noted(Bvh8Options{.cost = {.traversal = 3.0, .empty_bonus = 0.1}}),
                ElementsAre("cost.empty_bonus"));
}

TEST(BuildNotes, StandInTheReport) {
    const TriangleMesh mesh = make_soup(500, 0.1F, 1);
    const BuildReport wide = build_bvh8(mesh.view(), {.sample = {.rate = 0.05}}).report;
    ASSERT_EQ(wide.notes.size(), 1U);
    EXPECT_EQ(wide.notes[0].option, "sample.rate");
    EXPECT_EQ(sample_of(wide.options).rate, 0.05) << "what was asked";
    EXPECT_EQ(wide.sample.rate, 1.0) << "what was done";
    EXPECT_EQ(wide.sample_count, 500U);
    const BuildReport kd = build_kd_tree(mesh.view(), {.sample = {.seed = 5}}).report;
    ASSERT_EQ(kd.notes.size(), 1U);
    EXPECT_EQ(kd.notes[0],
              (BuildNote{"sample.seed", "no sample is drawn: all primitives are used"}));
}

TEST(BuildNotes, MethodsAskForNothingInVain) {
    for (const Method& method : method_registry()) {
        std::visit(
            [&](const auto& options) { EXPECT_THAT(noted(options), IsEmpty()) << method.name; },
            method.options());
    }
}

}  // namespace
}  // namespace coppice::test
