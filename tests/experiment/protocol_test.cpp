#include "experiment/protocol.h"

#include "coppice/base/error.h"

#include <gmock/gmock.h>

namespace coppice::lab {

namespace {

using testing::HasSubstr;

TEST(Protocol, RegistryHasTheThreeInOrder) {
    std::vector<std::string_view> names;
    for (const Protocol& protocol : protocol_registry()) {
        names.push_back(protocol.name);
        EXPECT_FALSE(protocol.summary.empty()) << protocol.name;
    }
    EXPECT_THAT(names, testing::ElementsAre("fixed", "scaled", "grown"));
}

TEST(Protocol, AllSetRateAndSeedAndKeepTheRest) {
    KdOptions base;
    base.split.rule = "median";
    base.split.max_depth = 17;
    base.split.clipping = Clipping::bounding_box;
    base.cost.traversal = 15.0;
    base.threads = 3;
    for (const Protocol& protocol : protocol_registry()) {
        const KdOptions options = protocol.options(base, 0.25, 7);
        EXPECT_EQ(options.sample.rate, 0.25) << protocol.name;
        EXPECT_EQ(options.sample.seed, 7U) << protocol.name;
        EXPECT_EQ(options.split.rule, "median") << protocol.name;
        EXPECT_EQ(options.split.max_depth, 17) << protocol.name;
        EXPECT_EQ(options.split.clipping, Clipping::bounding_box) << protocol.name;
        EXPECT_EQ(options.cost.traversal, 15.0) << protocol.name;
        EXPECT_EQ(options.threads, 3) << protocol.name;
    }
}

TEST(Protocol, FixedKeepsTheLeafLimit) {
    const KdOptions options = find_protocol("fixed").options({}, 0.01, 1);
    EXPECT_EQ(options.split.max_leaf, 32U);
    EXPECT_EQ(options.leaf_refinement, LeafRefinement::none);
}

TEST(Protocol, ScaledRoundsTheLeafLimitAndStopsAtOne) {
    const Protocol& scaled = find_protocol("scaled");
    EXPECT_EQ(scaled.options({}, 1.0, 1).split.max_leaf, 32U);
    EXPECT_EQ(scaled.options({}, 0.5, 1).split.max_leaf, 16U);
    EXPECT_EQ(scaled.options({}, 0.05, 1).split.max_leaf, 2U);  // 1.6
    EXPECT_EQ(scaled.options({}, 0.01, 1).split.max_leaf, 1U);  // 0.32
    EXPECT_EQ(scaled.options({}, 0.5, 1).leaf_refinement, LeafRefinement::none);
    KdOptions huge;
    huge.split.max_leaf = 4'294'967'295U;
    EXPECT_EQ(scaled.options(huge, 1.0, 1).split.max_leaf, 4'294'967'295U);
}

TEST(Protocol, GrownIsScaledAndGrowsOn) {
    const KdOptions options = find_protocol("grown").options({}, 0.1, 1);
    EXPECT_EQ(options.split.max_leaf, 3U);
    EXPECT_EQ(options.leaf_refinement, LeafRefinement::kd);
}

TEST(Protocol, UnknownNameListsThoseThatExist) {
    try {
        static_cast<void>(find_protocol("grwon"));
        FAIL() << "did not throw";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        EXPECT_THAT(error.what(), HasSubstr("'grwon'"));
        EXPECT_THAT(error.what(), HasSubstr("fixed, scaled, grown"));
    }
}

}  // namespace

}  // namespace coppice::lab
