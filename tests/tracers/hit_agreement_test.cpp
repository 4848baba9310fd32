#include "tracers/hit_agreement.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace coppice::lab {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(HitAgreement, DistancesAreTheSameWithinAShareOfTheLargerOne) {
    EXPECT_TRUE(is_same_distance(1000.0, 1000.0 * (1.0 + 0.9 * same_distance_share)));
    EXPECT_FALSE(is_same_distance(1000.0, 1000.0 * (1.0 + 1.1 * same_distance_share)));
    EXPECT_TRUE(is_same_distance(0.0, 0.0));
    EXPECT_FALSE(is_same_distance(0.0, 1e-30));
}

TEST(HitAgreement, AMissIsTheSameAsAMissOnly) {
    EXPECT_TRUE(is_same_distance(infinity, infinity));
    EXPECT_FALSE(is_same_distance(infinity, 1e300));
}

TEST(HitAgreement, MismatchesAreCounted) {
    const std::vector<Hit> reference{{.t = 1.0F}, {}, {.t = 3.0F}, {.t = 4.0F}};
    std::vector<Hit> hits = reference;
    EXPECT_EQ(count_mismatches(hits, reference), 0U);
    hits[1].t = 2.0F;  // hits nothing there is
    hits[2] = {};      // misses
    hits[3].t = 4.1F;  // hits elsewhere
    EXPECT_EQ(count_mismatches(hits, reference), 3U);
}

}  // namespace

}  // namespace coppice::lab
