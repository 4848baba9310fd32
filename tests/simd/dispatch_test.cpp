#include "simd/dispatch.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(Tables, GiveTheBestSetThatIsNotAboveTheProcessors) {
    constexpr int scalar = 1;
    constexpr int avx2 = 2;
    const simd::Tables<int> tables{{Isa::scalar, &scalar}, {Isa::avx2, &avx2}};
    EXPECT_EQ(&tables.at(Isa::scalar), &scalar);
    EXPECT_EQ(&tables.at(Isa::sse42), &scalar) << "none of its own";
    EXPECT_EQ(&tables.at(Isa::avx2), &avx2);
    EXPECT_EQ(&tables.at(Isa::avx512), &avx2);
}

}  // namespace
}  // namespace coppice::test
