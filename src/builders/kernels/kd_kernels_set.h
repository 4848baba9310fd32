// The inner loops of the k-d builders on the lanes of one instruction set.

#include "simd/set.h"

#if defined(COPPICE_BUILDERS_KERNELS_KD_KERNELS_SET_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_BUILDERS_KERNELS_KD_KERNELS_SET_H
#else
#define COPPICE_BUILDERS_KERNELS_KD_KERNELS_SET_H
#endif

#include "builders/kernels/bin_kernels.h"
#include "builders/kernels/kd_kernels.h"
#include "builders/kernels/plane_kernels.h"

namespace coppice::inline v0 {
namespace {
namespace COPPICE_SIMD_SET {

constexpr KdKernels kernels{&find_best_plane, &bin_ends};

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

#endif
