#include "rows/tree_key.h"

#include "rows/group_by.h"

#include <gtest/gtest.h>

#include <span>
#include <vector>

namespace coppice::lab {

namespace {

TreeKey key_of(const char* protocol, double percent, std::uint64_t seed) {
    return {{"triangles", protocol, "uniform"}, "dragon", percent, seed};
}

TEST(TreeKey, TwinsDifferInTheSeedOnly) {
    const TreeKey key = key_of("grown", 10.0, 1);
    EXPECT_TRUE(key.is_twin_of(key_of("grown", 10.0, 2)));
    EXPECT_FALSE(key.is_twin_of(key_of("grown", 20.0, 1)));
    EXPECT_FALSE(key.is_twin_of(key_of("fixed", 10.0, 1)));
    EXPECT_EQ(key.series(), key_of("grown", 20.0, 7).series());
    EXPECT_LT(key, key_of("grown", 10.0, 2));
}

TEST(GroupBy, KeepsTheOrderOfGroupsAndOfItems) {
    const std::vector<TreeKey> keys{key_of("grown", 1.0, 1), key_of("fixed", 1.0, 1),
                                    key_of("grown", 2.0, 1), key_of("grown", 1.0, 2)};
    const auto groups =
        group_by(std::span<const TreeKey>(keys),
                 [](const TreeKey& a, const TreeKey& b) { return a.series() == b.series(); });
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[0], (Group<TreeKey>{&keys[0], &keys[2], &keys[3]}));
    EXPECT_EQ(groups[1], (Group<TreeKey>{&keys[1]}));
}

}  // namespace

}  // namespace coppice::lab
