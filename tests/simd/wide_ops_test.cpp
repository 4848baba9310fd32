#include "simd/check_ops.h"

#include <gtest/gtest.h>

#define COPPICE_SIMD_KERNELS "simd/wide_ops.h"
#define COPPICE_SIMD_SETS (COPPICE_SIMD_AVX2 + COPPICE_SIMD_AVX512)
#include "simd/foreach_set.h"

namespace coppice::test {
namespace {

TEST(WideLanes, GiveWhatTheScalarOnesGive) {
    static constexpr simd::Tables<LaneOps> tables COPPICE_SIMD_TABLES;
    expect_like_scalar(tables);
}

}  // namespace
}  // namespace coppice::test
