#include "text/progress_line.h"

#include "text/remaining_time.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>

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

/// What a line that was shown for a while left in a file, which is no terminal.
std::string shown_in_a_file(std::chrono::milliseconds pause, std::chrono::milliseconds while_shown,
                            std::chrono::milliseconds while_cleared = {}) {
    std::FILE* file = std::tmpfile();
    if (file == nullptr) return "no temporary file";
    {
        ProgressLine line(file, pause);
        line.show("dragon", 3600.0);
        std::this_thread::sleep_for(while_shown);
        line.clear();
        std::this_thread::sleep_for(while_cleared);
    }
    std::string text(static_cast<std::size_t>(std::ftell(file)), ' ');
    std::rewind(file);
    text.resize(std::fread(text.data(), 1, text.size(), file));
    std::fclose(file);
    return text;
}

using namespace std::chrono_literals;

TEST(ProgressLine, WritesNothingBeforeTheFirstPauseWhereThereIsNoTerminal) {
    EXPECT_EQ(shown_in_a_file(1h, 5ms), "");
}

TEST(ProgressLine, WritesALineAfterEachPauseWhereThereIsNoTerminal) {
    const std::string text = shown_in_a_file(20ms, 500ms);
    EXPECT_EQ(text.rfind("coppice: dragon | ", 0), 0U) << text;
    EXPECT_NE(text.find(", about "), std::string::npos) << text;
    EXPECT_GE(std::count(text.begin(), text.end(), '\n'), 2);
    EXPECT_EQ(text.find('\r'), std::string::npos);
}

TEST(ProgressLine, WritesNothingAfterItWasClearedWhereThereIsNoTerminal) {
    EXPECT_EQ(shown_in_a_file(500ms, 0ms, 1200ms), "");
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
