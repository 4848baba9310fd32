#include "coppice/builders/build_report.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

constexpr StageReports example_stages{.sample = {0.5, 1.0, 500},
                                      .build = {1.0, 2.0, 7},
                                      .empty = {0.25, 0.25, 7},
                                      .refill = {2.0, 3.0, 1200},
                                      .refine = {4.0, 8.0, 1500}};

TEST(StageReports, AddUp) {
    EXPECT_EQ(StageReports{}.wall_seconds(), 0.0);
    EXPECT_EQ(example_stages.wall_seconds(), 7.75);
    EXPECT_EQ(example_stages.cpu_seconds(), 14.25);
}

}  // namespace
}  // namespace coppice::test
