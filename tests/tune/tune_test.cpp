#include "tune/tune.h"

#include "coppice/base/error.h"

#include "support/lab_scenes.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace coppice::lab {

namespace {

using testing::HasSubstr;
using testing::Not;

TuneRow make_row(const char* method, double percent, double build, double ray) {
    TuneRow row;
    row.method = method;
    row.sample_percent = percent;
    row.time = {build, ray};
    row.ray_seconds[0] = ray;
    return row;
}

/// Three trees, each the fastest for some number of rays, and one that never is.
TuneResult make_result(std::size_t chosen) {
    TuneResult result;
    result.scene.scene = "ball";
    result.rows = {make_row("fast", 1, 0.1, 4e-7), make_row("balanced", 10, 0.4, 2e-7),
                   make_row("quality", 100, 1.4, 1e-7), make_row("binned", 100, 5.0, 5e-7)};
    std::vector<TimeToImage> times;
    for (const TuneRow& row : result.rows) {
        times.push_back(row.time);
    }
    result.fastest = best_spans(times);
    result.chosen = chosen;
    return result;
}

TEST(Tune, SaysInOneSentenceWhatToUseAndWhy) {
    const TuneOptions options{.ray_count = 4e6};
    EXPECT_EQ(
        tune_sentence(options, make_result(1)),
        "ball: for 4e+06 rays use `balanced` from a sample of 10 %: with 0.4000 s to build and "
        "200.0 ns a ray they take 1.2000 s; `fast` from a sample of 1 % builds 0.3000 s sooner, "
        "but a ray takes 100.0 % longer, so that it is faster only up to 1.5e+06 rays; `quality` "
        "without sampling traces a ray in 50.0 % less time, but builds 1.0000 s longer, which "
        "pays only from 1e+07 rays.");
    EXPECT_THAT(tune_sentence({.ray_count = 1e5}, make_result(0)), Not(HasSubstr("sooner")));
    EXPECT_THAT(tune_sentence({.ray_count = 1e9}, make_result(2)), Not(HasSubstr("longer, which")));
    EXPECT_THAT(tune_sentence({.ray_count = 1.01e7}, make_result(2)),
                HasSubstr("within 3 % of it, which is noise: `balanced` from a sample of 10 %."));
}

TEST(Tune, KnowsByTheScatterOfRunsWhatIsNoise) {
    TuneResult result = make_result(2);
    const TuneOptions options{.ray_count = 1.2e7};
    EXPECT_THAT(tune_sentence(options, result), Not(HasSubstr("noise")));
    result.rows[2].measured.scatter = 0.1;
    EXPECT_THAT(tune_sentence(options, result), HasSubstr("within 10 % of it, which is noise"));
}

TEST(Tune, SaysSoWhereNothingElseIsBetter) {
    TuneResult result = make_result(0);
    result.fastest.resize(1);
    result.fastest[0].to = std::numeric_limits<double>::infinity();
    EXPECT_THAT(tune_sentence({}, result), HasSubstr("nothing else builds faster or traces"));
    EXPECT_THAT(tune_table({}, result), HasSubstr("for any number of rays"));
    result.rows.resize(1);
    EXPECT_THAT(tune_sentence({}, result), HasSubstr("nothing else was measured"));
}

TEST(Tune, TableAndDocumentHaveEveryRowAndBreakEven) {
    const TuneOptions options{.ray_count = 4e6};
    const std::vector results{make_result(1)};
    EXPECT_THAT(tune_table(options, results[0]), HasSubstr("from 1.5e+06 to 1e+07 rays"));
    const auto json = tune_document(options, results);
    const auto& scene = json["scenes"][0];
    EXPECT_EQ(scene["rows"].size(), 4U);
    EXPECT_EQ(scene["recommended"]["method"], "balanced");
    EXPECT_EQ(scene["answer"], tune_sentence(options, results[0]));
    EXPECT_EQ(scene["fastest"].size(), 3U);
    EXPECT_TRUE(scene["fastest"][2]["to_rays"].is_null());
    EXPECT_EQ(scene["break_even"].size(), 3U);
    EXPECT_EQ(scene["break_even"][0]["sooner"]["method"], "fast");
    EXPECT_DOUBLE_EQ(scene["break_even"][0]["rays"].get<double>(), 1.5e6);
}

TEST(Tune, MeasuresEachSampleOnce) {
    const test::TemporaryFolder folder;
    TuneOptions options;
    options.scenes = {folder.make_scene("balls.ply", "spheres", 500)};
    options.methods = {"exact", "sampled", "fast"};
    options.percents = {10, 100};
    options.threads = 1;
    options.runs = 1;
    options.size = 16;
    const auto results = run_tune(options);
    ASSERT_EQ(results.size(), 1U);
    std::vector<std::string> names;
    for (const TuneRow& row : results[0].rows) {
        names.push_back(row.method + (row.sample_percent < 100.0 ? " sampled" : ""));
        EXPECT_GT(row.time.build, 0.0);
        EXPECT_GT(row.time.ray, 0.0);
        EXPECT_EQ(row.measured.mismatches, 0U);
    }
    // The 8-wide tree does not sample so small a scene: both percentages are the same tree.
    EXPECT_THAT(names, testing::ElementsAre("exact", "sampled sampled", "sampled", "fast"));
    EXPECT_NEAR(results[0].rows[1].sample_percent, 10.0, 0.1);
}

TEST(Tune, RefusesWhatCannotBeMeasured) {
    const test::TemporaryFolder folder;
    TuneOptions good;
    good.scenes = {folder.make_scene("balls.ply", "spheres", 500)};
    good.runs = 1;
    good.size = 4;
    const auto refuses = [&](auto&& change) {
        TuneOptions options = good;
        change(options);
        EXPECT_THROW(static_cast<void>(run_tune(options)), Error);
    };
    refuses([](TuneOptions& options) { options.ray_count = 0.5; });
    refuses([](TuneOptions& options) { options.methods = {"best"}; });
    refuses([](TuneOptions& options) { options.percents = {}; });
    refuses([](TuneOptions& options) { options.percents = {0}; });
    refuses([](TuneOptions& options) {
        options.methods = {"fast"};
        options.rays = {RayKind::shadow};
        options.camera = {.eye = Vec3f{1e4F, 1e4F, 1e4F}, .look_at = Vec3f{2e4F, 1e4F, 1e4F}};
    });
}

}  // namespace

}  // namespace coppice::lab
