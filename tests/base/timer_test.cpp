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

}  // namespace
}  // namespace coppice::test
