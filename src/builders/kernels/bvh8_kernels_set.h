// The inner loops of the 8-wide builder on the lanes of one instruction set.

#include "simd/set.h"

#if defined(COPPICE_BUILDERS_KERNELS_BVH8_KERNELS_SET_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_BUILDERS_KERNELS_BVH8_KERNELS_SET_H
#else
#define COPPICE_BUILDERS_KERNELS_BVH8_KERNELS_SET_H
#endif

#include "builders/kernels/bvh8_kernels.h"
#include "builders/kernels/object_kernels.h"
#include "builders/kernels/spatial_kernels.h"

namespace coppice::inline v0::bvh8 {
namespace {
namespace COPPICE_SIMD_SET {

constexpr Kernels kernels{&unite,      &bin,          &find_split,   &partition,
                          &bin_pieces, &count_pieces, &write_pieces, &fill_block};

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0::bvh8

#endif
