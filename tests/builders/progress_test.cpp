// A build that is watched and held in check: its progress, a stop, a listener that throws, a limit
// on memory; for every method there is, and what is left of none of them.

#include "coppice/builders/progress.h"

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/estimate.h"
#include "coppice/builders/method.h"
#include "coppice/scene/scene.h"

#include "builders/run_build.h"
#include "builders/work_share.h"
#include "support/builds.h"
#include "support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

namespace coppice::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Enough for tasks of every kind.
const TriangleMesh& scene() {
    static const TriangleMesh mesh = make_soup(30'000, 0.02F, 1);
    return mesh;
}

/// Builds by a method as if the scene were large.
BuildReport build(const Method& method, const BuildControl& control) {
    BuildOptions options = options_as_if_large(method);
    set_threads(options, 2);
    return build_any(scene().view(), options, control).report;
}

TEST(Progress, StagesAreSharesOfTheWhole) {
    std::vector<double> told;
    Progress progress([&](double done) { told.push_back(done); });
    progress.begin_stage(0.25);
    progress.add(0.5);
    progress.begin_stage(0.75);
    progress.add(0.25);
    progress.add(1e-6);  // too little to tell
    progress.add(2.0);   // a stage is not more than itself, and the whole not done before the end
    progress.finish();
    EXPECT_EQ(told, (std::vector{0.0, 0.125, 0.25, 0.4375, 0.999, 1.0}));
}

TEST(WorkShare, OfANodeIsSharedOutAmongItsChildren) {
    double told = 0.0;
    Progress progress([&](double done) { told = done; });
    progress.begin_stage(0.5);
    const auto [below, above] = WorkShare(&progress).divide(100'000, 70'000, 40'000);
    const double own = told;
    EXPECT_GT(own, 0.0);
    above.done();
    const double of_above = told - own;
    EXPECT_GT(of_above, 0.0);
    below.part(0.25).done();
    below.part(0.75).done();
    EXPECT_NEAR(told, 0.5, 1e-3);
    EXPECT_GT(told - own - of_above, of_above * 70.0 / 40.0);  // more levels, too
}

TEST(WorkShare, ThatNobodyAsksAboutTellsNothing) {
    const WorkShare unasked(nullptr);
    EXPECT_FALSE(unasked.is_asked_for());
    const auto [below, above] = unasked.divide(10, 5, 5);
    EXPECT_FALSE(below.is_asked_for());
    EXPECT_NO_THROW(above.done());
}

class WatchedBuild : public testing::TestWithParam<Method> {};

TEST_P(WatchedBuild, TellsItsProgress) {
    std::vector<double> told;
    build(GetParam(), {.on_progress = [&](double done) { told.push_back(done); }});
    ASSERT_GE(told.size(), 10U);
    EXPECT_LE(told.size(), 1002U);
    EXPECT_EQ(told.front(), 0.0);
    EXPECT_EQ(told.back(), 1.0);
    for (std::size_t i = 1; i < told.size(); ++i) {
        ASSERT_LT(told[i - 1], told[i]);
    }
}

TEST_P(WatchedBuild, StopsWhereverItIs) {
    for (const double from : {0.0, 0.1, 0.4, 0.7, 0.95}) {
        std::stop_source stop;
        const auto request = [&](double done) {
            if (done >= from) stop.request_stop();
        };
        try {
            build(GetParam(), {.on_progress = request, .stop = stop.get_token()});
            EXPECT_GT(from, 0.9) << "it went on";  // what is left may be one step
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::cancelled);
            EXPECT_STREQ(error.what(), "cancelled: a stop was requested");
        }
    }
}

TEST_P(WatchedBuild, PassesOnWhatTheListenerThrows) {
    for (const double from : {0.0, 0.3, 0.8, 1.0}) {
        const auto refuse = [&](double done) {
            if (done >= from) throw std::out_of_range("enough");
        };
        EXPECT_THROW(build(GetParam(), {.on_progress = refuse}), std::out_of_range);
    }
}

TEST_P(WatchedBuild, KeepsWithinAMemoryLimitOrDoesNotBegin) {
    const Method& method = GetParam();
    const BuildReport free = build(method, {.memory_limit_bytes = std::uint64_t{1} << 40});
    ASSERT_TRUE(free.estimate.has_value());
    EXPECT_NEAR(free.estimate->peak_bytes, static_cast<double>(free.peak_bytes),
                0.5 * static_cast<double>(free.peak_bytes));
    EXPECT_EQ(free.preset_reason, "");
    try {
        bool has_begun = false;
        build(method, {.on_progress = [&](double) { has_begun = true; },
                       .memory_limit_bytes = 200'000,
                       .primitive_bytes = 150'000});
        ADD_FAILURE() << "no error; begun: " << has_begun;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::limit);
        EXPECT_THAT(error.what(), AllOf(HasSubstr(" would take about "), HasSubstr("MiB of memory"),
                                        HasSubstr(" beside the 146 KiB of its primitives; "
                                                  "the limit is 195 KiB")));
    }
}

INSTANTIATE_TEST_SUITE_P(Method, WatchedBuild,
                         testing::ValuesIn(method_registry().begin(), method_registry().end()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(MemoryLimit, AutomaticTakesTheSmallestPresetIfThatKeepsWithinIt) {
    const TriangleMeshView mesh = scene().view();
    Bvh8Options options;
    options.sampled_from = 0;
    options.expected_rays = 1e9;  // quality, were it not for the limit
    const BuildReport large = build_bvh8(mesh, options).report;
    ASSERT_EQ(large.preset, Bvh8Preset::quality);
    options.preset = Bvh8Preset::fast;
    const double small = estimate_bvh8(mesh, options).peak_bytes;
    ASSERT_LT(small, 0.95 * static_cast<double>(large.peak_bytes));

    options.preset = Bvh8Preset::automatic;
    const BuildControl limit{.memory_limit_bytes = static_cast<std::uint64_t>(1.01 * small)};
    const BuildReport report = build_bvh8(mesh, options, limit).report;
    EXPECT_EQ(report.preset, Bvh8Preset::fast);
    EXPECT_THAT(report.preset_reason, testing::StartsWith("quality would take about "));
    EXPECT_LE(report.peak_bytes, limit.memory_limit_bytes);
    options.preset = Bvh8Preset::quality;  // asked for by name, it is not replaced
    EXPECT_THROW(static_cast<void>(build_bvh8(mesh, options, limit)), Error);
}

TEST(RunBuild, WritesBytesAsPeopleReadThem) {
    EXPECT_EQ(bytes_text(0), "0 bytes");
    EXPECT_EQ(bytes_text(1), "1 byte");
    EXPECT_EQ(bytes_text(1023), "1023 bytes");
    EXPECT_EQ(bytes_text(1536), "1.50 KiB");
    EXPECT_EQ(bytes_text(200e6), "191 MiB");
    EXPECT_EQ(bytes_text(0x1p40), "1.00 TiB");
}

TEST(Scene, IsBuiltUnderControl) {
    double done = 0.0;
    const Scene built(scene(), {}, {.on_progress = [&](double share) { done = share; }});
    EXPECT_EQ(done, 1.0);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(Scene(scene(), {}, {.stop = stop.get_token()}), Error);
}

}  // namespace
}  // namespace coppice::test
