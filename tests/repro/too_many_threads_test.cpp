// oneTBB wrote a warning to stderr when asked for more threads than the hardware has; the library
// never prints.

#include "coppice/base/parallel.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(TooManyThreads, AreNoReasonToPrint) {
    testing::internal::CaptureStderr();
    run_with_threads(1000, [] { parallel_for_chunks(100, 1, [](std::size_t, std::size_t) {}); });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace coppice::test
