#include "coppice/builders/kd_options.h"

#include "coppice/base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace coppice::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string kd_error_of(const KdOptions& options) {
    try {
        require_valid(options);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        return error.what();
    }
    return "";
}

TEST(KdOptions, AcceptsItsRanges) {
    EXPECT_EQ(kd_error_of({}), "");
    EXPECT_EQ(kd_error_of({.sample = {.rate = 1e-300}}), "");
    EXPECT_EQ(kd_error_of({.split = {.max_depth = 0, .max_leaf = 1, .bad_refines = 1}}), "");
    EXPECT_EQ(kd_error_of({.split = {.max_depth = 60,
                                     .max_leaf = std::numeric_limits<std::uint32_t>::max(),
                                     .bad_refines = std::numeric_limits<int>::max()}}),
              "");
    EXPECT_EQ(kd_error_of({.threads = 1000}), "");
}

TEST(KdOptions, NamesWhatIsOutside) {
    EXPECT_EQ(kd_error_of({.sample = {.rate = 1.5}}), "sample rate 1.5 is outside (0, 1]");
    EXPECT_THAT(kd_error_of({.sample = {.rate = std::nan("")}}), StartsWith("sample rate nan"));
    EXPECT_EQ(kd_error_of({.sample = {.uniform_share = -0.5}}),
              "uniform share -0.5 is outside [0, 1]");
    EXPECT_EQ(kd_error_of({.split = {.max_depth = -1}}), "max depth -1 is outside [0, 60]");
    EXPECT_EQ(kd_error_of({.split = {.max_depth = 61}}), "max depth 61 is outside [0, 60]");
    EXPECT_EQ(kd_error_of({.split = {.max_leaf = 0}}), "max leaf 0 is outside [1, 2^32)");
    EXPECT_EQ(kd_error_of({.split = {.bad_refines = 0}}), "bad refines 0 is outside [1, 2^31)");
    EXPECT_EQ(kd_error_of({.split = {.bad_refines = -7}}), "bad refines -7 is outside [1, 2^31)");
    EXPECT_EQ(kd_error_of({.split = {.max_duplication = 0}}),
              "max duplication 0 is outside [1, 2^32)");
    EXPECT_EQ(kd_error_of({.split = {.min_split = 0}}), "min split 0 is outside [1, 2^32)");
    EXPECT_EQ(kd_error_of({.threads = -1}), "threads must be 0 (all) or more, not -1");
    EXPECT_EQ(kd_error_of({.cost = {.traversal = -1.0}}), "traversal cost -1 is outside [0, inf)");
}

TEST(KdOptions, NamesWhatExists) {
    EXPECT_THAT(kd_error_of({.sample = {.sampler = "best"}}),
                StartsWith("unknown sampler 'best'; choose one of: uniform"));
    EXPECT_THAT(kd_error_of({.split = {.rule = "best"}}),
                StartsWith("unknown split rule 'best'; choose one of: sah, median, midpoint"));
}

TEST(KdOptions, EnumeratorsHaveStableNames) {
    EXPECT_STREQ(name_of(Clipping::perfect), "perfect");
    EXPECT_STREQ(name_of(Clipping::bounding_box), "bounding_box");
    EXPECT_STREQ(name_of(SampleWeighting::sampled), "sampled");
    EXPECT_STREQ(name_of(SampleWeighting::expected), "expected");
    EXPECT_STREQ(name_of(Termination::limits), "limits");
    EXPECT_STREQ(name_of(Termination::sah), "sah");
    EXPECT_STREQ(name_of(LeafRefinement::none), "none");
    EXPECT_STREQ(name_of(LeafRefinement::kd), "kd");
}

TEST(KdOptions, DefaultsAreDocumented) {
    const KdOptions options;
    EXPECT_EQ(options.sample.rate, 1.0);
    EXPECT_EQ(options.sample.sampler, "uniform");
    EXPECT_EQ(options.sample.seed, 1U);
    EXPECT_EQ(options.split.rule, "sah");
    EXPECT_EQ(options.split.max_depth, 50);
    EXPECT_EQ(options.split.max_leaf, 32U);
    EXPECT_EQ(options.split.bad_refines, 3);
    EXPECT_EQ(options.split.clipping, Clipping::perfect);
    EXPECT_EQ(options.split.sample_weighting, SampleWeighting::sampled);
    EXPECT_EQ(options.split.termination, Termination::limits);
    EXPECT_EQ(options.split.min_split, 1U);
    EXPECT_EQ(options.split.max_duplication, std::numeric_limits<std::uint32_t>::max());
    EXPECT_EQ(options.leaf_refinement, LeafRefinement::kd);
    EXPECT_EQ(options.threads, 0);
}

}  // namespace
}  // namespace coppice::test
