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
    EXPECT_LT(first, 10.0);
    EXPECT_GE(timer.seconds(), first);
    timer.restart();
    EXPECT_LT(timer.seconds(), first);
}

TEST(CpuTimer, CountsWorkAndNotSleep) {
    CpuTimer cpu;
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    EXPECT_LT(cpu.seconds(), 0.025);
    cpu.restart();
    const Timer wall;
    while (cpu.seconds() < 0.01 && wall.seconds() < 10.0) {
    }
    EXPECT_GE(cpu.seconds(), 0.01);
    EXPECT_GT(process_cpu_seconds(), 0.0);
}

}  // namespace
}  // namespace coppice::test
