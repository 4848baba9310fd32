#include "text/build_text.h"

#include <gmock/gmock.h>

namespace coppice::lab {

namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

BuildReport example_report() {
    BuildReport report;
    report.method = "sampled";
    report.primitive_count = 1000;
    report.sample_count = 10;
    report.stages.sample = {0.5, 1.0, 10};
    report.stages.refine = {1.5, 3.0, 1700};
    report.tree_bytes = 20000;
    report.peak_bytes = 90000;
    report.statistics.node_count = 401;
    report.statistics.reference_count = 1700;
    report.statistics.sah_cost = 42.5;
    return report;
}

TEST(BuildText, TellsStagesTreeAndMemory) {
    const std::string text = build_text("dragon", "k-d tree", example_report());
    EXPECT_THAT(text, HasSubstr("dragon: sampled, k-d tree, 10 of 1000 primitives sampled"));
    EXPECT_THAT(text, ContainsRegex("\n  sample +0.500000 +1.000000 +10 primitives\n"));
    EXPECT_THAT(text, ContainsRegex("\n  refine +1.500000 +3.000000 +1700 references\n"));
    EXPECT_THAT(text, ContainsRegex("\n  total +2.000000 +4.000000\n"));
    EXPECT_THAT(text, HasSubstr("401 nodes"));
    EXPECT_THAT(text, HasSubstr("cost     42.5000"));
    EXPECT_THAT(text, HasSubstr("20000 bytes kept (20.0 a primitive), 90000 at most"));
    EXPECT_THAT(text, Not(HasSubstr("estimated")));
}

TEST(BuildText, HasEstimatesBesideWhatWasFound) {
    BuildReport report = example_report();
    report.estimate = {1870.0, 19000.0, 90000.0, 3.0};
    const std::string text = build_text("dragon", "k-d tree", report);
    EXPECT_THAT(text, ContainsRegex("\n  references +1870 +1700 +\\+10.0 %\n"));
    EXPECT_THAT(text, ContainsRegex("\n  bytes kept +19000 +20000 +-5.0 %\n"));
    EXPECT_THAT(text, ContainsRegex("\n  wall seconds +3.0000 +2.0000 +\\+50.0 %\n"));
}

TEST(BuildText, DividesByNothing) {
    EXPECT_THAT(build_text("none", "k-d tree", BuildReport{}), HasSubstr("(0.0 a primitive)"));
}

}  // namespace

}  // namespace coppice::lab
