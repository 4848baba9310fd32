#include "coppice/base/timer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace coppice::test {
namespace {

TEST(Timer, CountsSecondsAndRestarts) {
    using std::chrono::milliseconds;
    Timer timer;
    std::this_thread::sleep_for(milliseconds(20));
    const double first = timer.seconds();
    EXPECT_GE(first, 0.020);
    EXPECT_GE(timer.seconds(), first);
    // An outer timer that was not restarted is always ahead, however slow the machine is.
    const Timer outer = timer;
    timer.restart();
    const double since_restart = timer.seconds();
    EXPECT_LE(since_restart + first, outer.seconds() + 1e-9);
}

TEST(CpuTimer, CountsWork) {
    const CpuTimer cpu;
    while (cpu.seconds() < 0.01) {  // ends only if the work of the loop is counted
    }
    EXPECT_GE(process_cpu_seconds(), 0.01);
}

TEST(CpuTimer, CountsLessOfASleepThanTheClockOnTheWall) {
    // One thread sleeps, so that the process cannot work for as long as the wall clock says.
    const Timer wall;
    const CpuTimer cpu;
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    const double worked = cpu.seconds();
    EXPECT_LT(worked, wall.seconds());
}

}  // namespace
}  // namespace coppice::test
