#include "text/progress_line.h"

#include "text/remaining_time.h"

#include <gtest/gtest.h>

namespace coppice::lab {

namespace {

TEST(ProgressLine, Durations) {
    EXPECT_EQ(duration_text(-3.0), "0 s");
    EXPECT_EQ(duration_text(0.4), "0 s");
    EXPECT_EQ(duration_text(59.4), "59 s");
    EXPECT_EQ(duration_text(59.6), "1:00");
    EXPECT_EQ(duration_text(127.0), "2:07");
    EXPECT_EQ(duration_text(3727.0), "1:02:07");
    EXPECT_EQ(duration_text(1e300), "100:00:00");
}

TEST(ProgressLine, TextHasElapsedAndRemainingTime) {
    EXPECT_EQ(progress_text("dragon", 61.0, 12.0, 80), "dragon | 1:01, about 12 s left");
    EXPECT_EQ(progress_text("dragon", 3.0, {}, 80), "dragon | 3 s");
}

TEST(ProgressLine, TextIsCutToTheWidthTimesLast) {
    EXPECT_EQ(progress_text("a long scene name", 3.0, {}, 12), "a long | 3 s");
    EXPECT_EQ(progress_text("dragon", 3.0, {}, 4), " | 3");
    EXPECT_EQ(progress_text("dragon", 3.0, {}, 0), "");
    EXPECT_EQ(progress_text("dragon", 3.0, {}, -1), "");
}

TEST(ProgressLine, WritesNothingWhereThereIsNoTerminal) {
    std::FILE* file = std::tmpfile();
    ASSERT_NE(file, nullptr);
    {
        ProgressLine line(file);
        EXPECT_FALSE(line.is_active());
        line.show("dragon", 3.0);
        line.clear();
    }
    EXPECT_EQ(std::ftell(file), 0);
    std::fclose(file);
}

TEST(RemainingTime, UnknownUntilSomethingIsDone) {
    RemainingTime remaining;
    remaining.plan(10.0);
    EXPECT_FALSE(remaining.seconds().has_value());
    remaining.finish(4.0, 2.0);
    EXPECT_EQ(remaining.seconds(), 3.0);
    remaining.finish(6.0, 3.0);
    EXPECT_EQ(remaining.seconds(), 0.0);
}

}  // namespace

}  // namespace coppice::lab
