#include "experiment/build_work.h"

#include <gtest/gtest.h>

namespace coppice::lab {

namespace {

TEST(BuildWork, GrowsWithRateAndPrimitives) {
    const auto work = [](PrimitiveKind kind, std::string_view protocol, double percent) {
        return work_of_build({kind, protocol, percent, 1000.0});
    };
    EXPECT_GT(work(PrimitiveKind::points, "fixed", 100), work(PrimitiveKind::points, "fixed", 1));
    EXPECT_GT(work(PrimitiveKind::points, "fixed", 1), 0.0);
    EXPECT_GT(work(PrimitiveKind::triangles, "fixed", 1), work(PrimitiveKind::points, "fixed", 1));
    EXPECT_GT(work(PrimitiveKind::points, "grown", 1), work(PrimitiveKind::points, "fixed", 1));
}

}  // namespace

}  // namespace coppice::lab
