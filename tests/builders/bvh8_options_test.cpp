#include "coppice/builders/bvh8_options.h"

#include "coppice/base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace coppice::test {
namespace {

using testing::StartsWith;

std::string bvh8_error_of(const Bvh8Options& options) {
    try {
        require_valid(options);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        return error.what();
    }
    return "";
}

TEST(Bvh8Options, AcceptTheirRanges) {
    EXPECT_EQ(bvh8_error_of({}), "");
    EXPECT_EQ(bvh8_error_of({.expected_rays = std::numeric_limits<double>::infinity()}), "");
    EXPECT_EQ(bvh8_error_of({.expected_rays = 0.0, .cell_size = 64, .sampled_from = 0}), "");
}

TEST(Bvh8Options, NameWhatIsOutside) {
    EXPECT_EQ(bvh8_error_of({.cell_size = 63}), "cell size 63 is outside [64, 2^32) and not 0");
    EXPECT_EQ(bvh8_error_of({.expected_rays = -1.0}), "expected rays -1 is outside [0, inf]");
    EXPECT_THAT(bvh8_error_of({.expected_rays = std::nan("")}), StartsWith("expected rays nan"));
    EXPECT_EQ(bvh8_error_of({.sample = {.rate = 2.0}}), "sample rate 2 is outside (0, 1]");
    EXPECT_EQ(bvh8_error_of({.threads = -1}), "threads must be 0 (all) or more, not -1");
    EXPECT_THAT(bvh8_error_of({.cost = {.intersection = 0.0}}), StartsWith("intersection cost 0"));
}

TEST(Bvh8Options, PresetsHaveStableNames) {
    EXPECT_STREQ(name_of(Bvh8Preset::automatic), "automatic");
    EXPECT_STREQ(name_of(Bvh8Preset::fast), "fast");
    EXPECT_STREQ(name_of(Bvh8Preset::balanced), "balanced");
    EXPECT_STREQ(name_of(Bvh8Preset::quality), "quality");
}

TEST(Bvh8Options, DefaultsAreDocumented) {
    const Bvh8Options options;
    EXPECT_EQ(options.sample.rate, 1.0);
    EXPECT_EQ(options.preset, Bvh8Preset::automatic);
    EXPECT_EQ(options.expected_rays, 1e7);
    EXPECT_EQ(options.cell_size, 0U);
    EXPECT_EQ(options.sampled_from, 200'000U);
    EXPECT_EQ(options.threads, 0);
}

}  // namespace
}  // namespace coppice::test
