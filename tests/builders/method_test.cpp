#include "coppice/builders/method.h"

#include "coppice/base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace coppice::test {
namespace {

TEST(MethodRegistry, HasDistinctNamesAndLegalOptions) {
    std::set<std::string_view> names;
    for (const Method& method : method_registry()) {
        EXPECT_TRUE(names.insert(method.name).second) << method.name;
        EXPECT_FALSE(method.summary.empty()) << method.name;
        EXPECT_NO_THROW(check(method.options())) << method.name;
        EXPECT_EQ(&find_method(method.name), &method);
    }
}

TEST(MethodRegistry, SweepIsTheThesis) {
    const BuildOptions options = find_method("sweep").options();
    EXPECT_EQ(options.split.rule, SplitOptions{}.rule);
    EXPECT_EQ(options.split.max_leaf, 32U);
    EXPECT_EQ(options.split.termination, Termination::limits);
    EXPECT_EQ(options.sample.rate, 1.0);
    EXPECT_EQ(options.leaf_refinement, LeafRefinement::none);
}

TEST(MethodRegistry, Bvh8MethodsDifferByTheirPreset) {
    EXPECT_EQ(find_method("fast").options().bvh8.preset, Bvh8Preset::fast);
    EXPECT_EQ(find_method("balanced").options().bvh8.preset, Bvh8Preset::balanced);
    EXPECT_EQ(find_method("quality").options().bvh8.preset, Bvh8Preset::quality);
    EXPECT_EQ(find_method("auto").options().bvh8.preset, Bvh8Preset::automatic);
    EXPECT_EQ(find_method("auto").tree, TreeKind::bvh8);
    EXPECT_EQ(find_method("exact").tree, TreeKind::kd);
}

TEST(FindMethod, NamesThoseThatExist) {
    try {
        static_cast<void>(find_method("best"));
        FAIL() << "no exception";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        EXPECT_THAT(error.what(), testing::StartsWith("no method 'best'; there are: exact, "));
    }
}

}  // namespace
}  // namespace coppice::test
