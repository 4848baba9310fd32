#include "coppice/builders/method.h"

#include "coppice/base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string_view>
#include <vector>

namespace coppice::test {
namespace {

TEST(MethodRegistry, HasDistinctNamesAndLegalOptions) {
    std::set<std::string_view> names;
    for (const Method& method : method_registry()) {
        EXPECT_TRUE(names.insert(method.name).second) << method.name;
        EXPECT_FALSE(method.summary.empty()) << method.name;
        EXPECT_NO_THROW(
            std::visit([](const auto& options) { require_valid(options); }, method.options()))
            << method.name;
        EXPECT_EQ(&find_method(method.name), &method);
    }
}

TEST(MethodRegistry, SweepIsTheThesis) {
    const KdOptions options = find_method("sweep").kd_options();
    EXPECT_EQ(options.split.rule, SplitOptions{}.rule);
    EXPECT_EQ(options.split.max_leaf, 32U);
    EXPECT_EQ(options.split.termination, Termination::limits);
    EXPECT_EQ(options.sample.rate, 1.0);
    EXPECT_EQ(options.leaf_refinement, LeafRefinement::none);
}

TEST(MethodRegistry, Bvh8MethodsDifferByTheirPreset) {
    EXPECT_EQ(find_method("fast").bvh8_options().preset, Bvh8Preset::fast);
    EXPECT_EQ(find_method("balanced").bvh8_options().preset, Bvh8Preset::balanced);
    EXPECT_EQ(find_method("quality").bvh8_options().preset, Bvh8Preset::quality);
    EXPECT_EQ(find_method("auto").bvh8_options().preset, Bvh8Preset::automatic);
    EXPECT_EQ(find_method("auto").tree(), TreeKind::bvh8);
    EXPECT_EQ(find_method("exact").tree(), TreeKind::kd);
}

TEST(MethodRegistry, MethodsKnowWhatTheyDo) {
    std::vector<std::string_view> sampling;
    std::vector<std::string_view> automatic;
    for (const Method& method : method_registry()) {
        if (method.uses_sample()) sampling.push_back(method.name);
        if (method.is_automatic()) automatic.push_back(method.name);
    }
    EXPECT_THAT(sampling, testing::ElementsAre("sampled", "fast", "balanced"));
    EXPECT_THAT(automatic, testing::ElementsAre("auto"));
}

TEST(MethodRegistry, OptionsAreOfTheKindThatTheMethodBuilds) {
    try {
        static_cast<void>(find_method("exact").bvh8_options());
        FAIL() << "no exception";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        EXPECT_STREQ(error.what(), "the method 'exact' does not build 8-wide trees");
    }
    EXPECT_THROW(static_cast<void>(find_method("fast").kd_options()), Error);
}

TEST(FindMethod, NamesThoseThatExist) {
    try {
        static_cast<void>(find_method("best"));
        FAIL() << "no exception";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        EXPECT_THAT(error.what(),
                    testing::StartsWith("unknown method 'best'; choose one of: exact, "));
    }
}

}  // namespace
}  // namespace coppice::test
