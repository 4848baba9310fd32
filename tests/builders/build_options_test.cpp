#include "coppice/builders/build_options.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(BuildOptions, GiveWhatBothKindsHave) {
    for (BuildOptions options : {BuildOptions(KdOptions{}), BuildOptions(Bvh8Options{})}) {
        sample_of(options).rate = 0.25;
        cost_of(options).traversal = 7.0;
        set_threads(options, 3);
        std::visit(
            [](const auto& of) {
                EXPECT_EQ(of.sample.rate, 0.25);
                EXPECT_EQ(of.cost.traversal, 7.0);
                EXPECT_EQ(of.threads, 3);
            },
            options);
        const BuildOptions& seen = options;
        EXPECT_EQ(sample_of(seen).rate, 0.25);
        EXPECT_EQ(cost_of(seen).traversal, 7.0);
        EXPECT_EQ(threads_of(seen), 3);
    }
    EXPECT_EQ(tree_kind(KdOptions{}), TreeKind::kd);
    EXPECT_EQ(tree_kind(Bvh8Options{}), TreeKind::bvh8);
}

}  // namespace
}  // namespace coppice::test
