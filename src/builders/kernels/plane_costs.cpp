// Counts PrimRefs on both sides of the planes of a small node, and evaluates the heuristic there:
// each PrimRef is compared with vectors of planes, without a branch and without sorting.
// Cost: O(PrimRefs planes / 8), less than a sort up to some 64 PrimRefs, where most nodes of a
// k-d tree are.
//
// Where there are many ends, half of them are left out. Between ends the cost is linear in the
// position: it falls where more reaches above than below, and rises after that. So before that
// place only starts come into question, and after it only ends.
//
// No fused multiply-add may be used here: costs must equal those of the scalar code.

#include "builders/kernels/plane_costs.h"

#include "base/isa.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

#if !defined(__clang__)
// All that takes or returns vectors is inline: there is no calling convention to care about.
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

// What a kernel calls must be part of it, or vectors are passed in memory.
#define COPPICE_IN_KERNEL [[gnu::always_inline]] inline

namespace coppice::inline v0 {
namespace {

namespace scalar {
#include "builders/kernels/plane_costs.inl"
}  // namespace scalar

#if defined(__x86_64__)
COPPICE_BEGIN_AVX2

namespace avx2 {
#include "builders/kernels/plane_costs.inl"
}  // namespace avx2

COPPICE_END_ISA
#endif

}  // namespace

PlaneKernel plane_kernel_for([[maybe_unused]] Isa isa) noexcept {
#if defined(__x86_64__)
    if (isa >= Isa::avx2) return &avx2::find_best_plane;
#endif
    return &scalar::find_best_plane;
}

}  // namespace coppice::inline v0
