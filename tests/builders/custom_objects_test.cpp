// A sampler, a split rule and a cost model of one's own, passed as objects.

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/draw_sample.h"
#include "coppice/builders/split_finder.h"
#include "coppice/cost/measure.h"

#include "support/meshes.h"
#include "support/tree_checks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

namespace coppice::test {
namespace {

class Drawn final : public Sampler {
public:
    explicit Drawn(std::function<void(Sample&, std::uint32_t)> fill) : fill_(std::move(fill)) {}

    [[nodiscard]] Sample draw(PrimitiveSetView /*primitives*/, std::uint32_t count,
                              const SampleOptions& options) const override {
        Sample sample{{}, {}, options};
        fill_(sample, count);
        return sample;
    }

private:
    std::function<void(Sample&, std::uint32_t)> fill_;
};

std::shared_ptr<const Sampler> drawn(std::function<void(Sample&, std::uint32_t)> fill) {
    return std::make_shared<Drawn>(std::move(fill));
}

void take_first(Sample& sample, std::uint32_t count) {
    for (std::uint32_t id = 0; id < count; ++id) {
        sample.ids.push_back(id);
    }
}

TEST(CustomSampler, IsAskedInPlaceOfTheNamedOne) {
    const TriangleMesh mesh = make_soup(1000, 0.1F, 1);
    const SampleOptions options{.rate = 0.1, .custom_sampler = drawn(take_first)};
    EXPECT_EQ(draw_sample(mesh.view(), options).ids.back(), 99U);
    const auto [tree, report] = build_kd_tree(mesh.view(), {.sample = options});
    EXPECT_EQ(report.sample_count, 100U);
    EXPECT_TRUE(is_sound(tree, mesh.view()));
    EXPECT_FALSE(tree == build_kd_tree(mesh.view(), {.sample = {.rate = 0.1}}).tree);
    for (const Bvh8Preset preset : {Bvh8Preset::fast, Bvh8Preset::balanced}) {
        const auto [wide, wide_report] = build_bvh8(
            mesh.view(), {.sample = options, .preset = preset, .cell_size = 64, .sampled_from = 0});
        EXPECT_EQ(wide_report.sample_count, 100U);
        EXPECT_TRUE(is_sound(wide, mesh.view()));
    }
}

TEST(CustomSampler, ThatBreaksItsContractIsAnError) {
    const TriangleMesh mesh = make_soup(100, 0.1F, 1);
    const auto error_of = [&](std::function<void(Sample&, std::uint32_t)> fill) {
        try {
            static_cast<void>(
                draw_sample(mesh.view(), {.rate = 0.1, .custom_sampler = drawn(std::move(fill))}));
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
            return std::string(error.what());
        }
        return std::string("none");
    };
    EXPECT_EQ(error_of(take_first), "none");
    EXPECT_EQ(error_of([](Sample&, std::uint32_t) {}), "the custom sampler drew no primitives");
    EXPECT_EQ(error_of([](Sample& sample, std::uint32_t) {
                  sample.ids = {5, 100};
              }),
              "the custom sampler drew id 100, but there are 100 primitives");
    EXPECT_EQ(error_of([](Sample& sample, std::uint32_t) {
                  sample.ids = {5, 5};
              }),
              "the custom sampler drew ids that are not strictly ascending");
    EXPECT_EQ(error_of([](Sample& sample, std::uint32_t) {
                  sample.ids = {5, 6};
                  sample.weights = {1.0F};
              }),
              "the custom sampler returned 1 weights for 2 primitives");
}

// Hands on to a rule of the library, and counts how often it is asked.
class Counted final : public SplitFinder {
public:
    explicit Counted(const char* rule, bool is_exact = false)
        : rule_(find_split_finder(rule)), is_exact_(is_exact) {}

    [[nodiscard]] std::optional<SplitCandidate> find(const SplitQuery& query) const override {
        ++calls;
        return rule_.find(query);
    }

    [[nodiscard]] bool finds_cheapest_end() const noexcept override { return is_exact_; }

    mutable std::atomic<int> calls = 0;

private:
    const SplitFinder& rule_;
    bool is_exact_;
};

TEST(CustomRule, IsAskedInPlaceOfTheNamedOne) {
    const TriangleMesh mesh = make_soup(3000, 0.05F, 2);
    for (const char* const rule : {"sah", "median", "exact"}) {
        const auto custom = std::make_shared<const Counted>(rule);
        const KdTree tree = build_kd_tree(mesh.view(), {.split = {.custom_rule = custom}}).tree;
        EXPECT_TRUE(tree == build_kd_tree(mesh.view(), {.split = {.rule = rule}}).tree) << rule;
        EXPECT_GT(custom->calls, 100) << rule;
    }
}

TEST(CustomRule, ThatFindsTheCheapestEndIsNotAskedAboutLargeNodes) {
    const TriangleMesh mesh = make_soup(3000, 0.05F, 2);
    const auto asked = std::make_shared<const Counted>("exact");
    const auto trusted = std::make_shared<const Counted>("exact", true);
    const auto build = [&](const std::shared_ptr<const Counted>& rule) {
        return build_kd_tree(mesh.view(),
                             {.split = {.termination = Termination::sah, .custom_rule = rule}})
            .tree;
    };
    EXPECT_TRUE(build(asked) == build(trusted));
    EXPECT_LT(trusted->calls, asked->calls);
}

// The constants of the usual model, as an object.
class AsObject final : public CostModel {
public:
    explicit AsObject(SahCostModel model) : model_(std::move(model)) {}

    [[nodiscard]] double traversal_cost() const noexcept override { return model_.traversal; }

    [[nodiscard]] double leaf_cost(double count) const noexcept override {
        return model_.leaf_cost(count);
    }

    [[nodiscard]] double split_cost(double p_below, double count_below, double p_above,
                                    double count_above) const noexcept override {
        return model_.split_cost(p_below, count_below, p_above, count_above);
    }

private:
    SahCostModel model_;
};

// Nodes that the library's kernels search have the same splits by an object of the same costs.
TEST(CustomCost, OfTheUsualFormulaGivesTheUsualTree) {
    const TriangleMesh mesh = make_soup(3000, 0.05F, 3);
    const SahCostModel usual{.traversal = 3.0, .intersection = 2.0, .empty_bonus = 0.0};
    const SahCostModel custom{.custom = std::make_shared<AsObject>(usual)};
    for (const char* const rule : {"sah", "median", "midpoint", "exact", "binned", "adaptive"}) {
        for (const double rate : {1.0, 0.1}) {
            const auto build = [&](const SahCostModel& cost) {
                return build_kd_tree(mesh.view(), {.sample = {.rate = rate},
                                                   .split = {.rule = rule, .max_leaf = 2},
                                                   .cost = cost});
            };
            const auto [expected, expected_report] = build(usual);
            const auto [tree, report] = build(custom);
            EXPECT_TRUE(tree == expected) << rule << " at " << rate;
            EXPECT_EQ(report.statistics.sah_cost, expected_report.statistics.sah_cost);
        }
    }
}

// Testing eight costs what testing one does.
class Batches final : public CostModel {
    [[nodiscard]] double traversal_cost() const noexcept override { return 1.0; }

    [[nodiscard]] double leaf_cost(double count) const noexcept override {
        return std::ceil(count / 8.0);
    }
};

TEST(CustomCost, IsWhatTreesAreBuiltFor) {
    const TriangleMesh mesh = make_soup(3000, 0.05F, 4);
    const SahCostModel batches{.custom = std::make_shared<Batches>()};
    const SplitOptions split{.rule = "exact", .termination = Termination::sah};
    const auto [tree, report] = build_kd_tree(mesh.view(), {.split = split, .cost = batches});
    EXPECT_TRUE(is_sound(tree, mesh.view()));
    EXPECT_EQ(report.statistics.sah_cost, measure(tree, batches).sah_cost);
    const KdTree usual = build_kd_tree(mesh.view(), {.split = split}).tree;
    EXPECT_LT(report.statistics.sah_cost, measure(usual, batches).sah_cost);
    EXPECT_GT(report.statistics.mean_leaf_size, 3.0);
}

TEST(CustomCost, MeasuresAnEightWideTree) {
    const TriangleMesh mesh = make_soup(500, 0.05F, 4);
    const SahCostModel usual{.traversal = 2.0, .intersection = 3.0};
    const SahCostModel custom{.custom = std::make_shared<AsObject>(usual)};
    const auto [tree, report] = build_bvh8(mesh.view(), {.cost = custom});
    EXPECT_EQ(report.statistics.sah_cost, measure(tree, usual).sah_cost);
    EXPECT_NE(report.statistics.sah_cost, measure(tree, {}).sah_cost);
}

}  // namespace
}  // namespace coppice::test
