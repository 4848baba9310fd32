// What every split rule promises, and the list of them.

#include "coppice/base/error.h"
#include "coppice/builders/build_options.h"
#include "coppice/builders/split_finder.h"

#include "builders/prim_refs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

namespace coppice::test {
namespace {

class EverySplitFinder : public testing::TestWithParam<std::string> {};

TEST_P(EverySplitFinder, OffersPlanesInsideAtTheirCost) {
    const SplitFinder& finder = find_split_finder(GetParam());
    const SahCostModel model{.traversal = 1.5, .intersection = 2.0, .empty_bonus = 0.3};
    Random random(12);
    for (const Layout layout :
         {Layout::random, Layout::grid, Layout::planar, Layout::points, Layout::identical}) {
        for (int round = 0; round < 100; ++round) {
            const auto prim_refs = make_prim_refs(layout, 1 + random.below(40), random);
            for (const double acceptable : {std::numeric_limits<double>::infinity(), 10.0, 0.0}) {
                const auto split = finder.find({prim_refs, unit_cube, model, acceptable});
                if (!split) continue;
                EXPECT_GT(split->plane.position, 0.0F);
                EXPECT_LT(split->plane.position, 1.0F);
                EXPECT_NEAR(
                    split->cost,
                    naive_split_cost(prim_refs, unit_cube, model, split->plane, split->planar_side),
                    1e-9 * split->cost);
            }
        }
    }
}

TEST_P(EverySplitFinder, IsStateless) {
    const SplitFinder& finder = find_split_finder(GetParam());
    const SahCostModel model;
    Random random(13);
    const auto prim_refs = make_prim_refs(Layout::random, 100, random);
    const auto others = make_prim_refs(Layout::grid, 50, random);
    const auto first = finder.find({prim_refs, unit_cube, model, 0.0});
    static_cast<void>(finder.find({others, unit_cube, model, 0.0}));
    const auto second = finder.find({prim_refs, unit_cube, model, 0.0});
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->plane, second->plane);
    EXPECT_EQ(first->cost, second->cost);
}

std::vector<std::string> rule_names() {
    std::vector<std::string> names;
    for (const SplitFinderEntry& entry : split_finder_registry()) {
        names.emplace_back(entry.name);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Named, EverySplitFinder, testing::ValuesIn(rule_names()),
                         [](const auto& each) { return each.param; });

TEST(SplitFinderRegistry, NamesAreUniqueAndSummariesThere) {
    std::set<std::string_view> names;
    for (const SplitFinderEntry& entry : split_finder_registry()) {
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
        EXPECT_FALSE(entry.name.empty());
        EXPECT_FALSE(entry.summary.empty());
        EXPECT_EQ(&find_split_finder(entry.name), &entry.finder);
    }
    EXPECT_EQ(split_finder_registry().front().name, SplitOptions{}.rule);
}

TEST(FindSplitFinder, NamesThoseThatExist) {
    try {
        static_cast<void>(find_split_finder("best"));
        FAIL() << "no exception";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        EXPECT_THAT(
            error.what(),
            testing::StartsWith("unknown split rule 'best'; choose one of: sah, median, midpoint"));
    }
}

}  // namespace
}  // namespace coppice::test
