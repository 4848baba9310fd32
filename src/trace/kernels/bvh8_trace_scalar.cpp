#include "trace/hit_list.h"
#include "trace/kernels/bvh8_trace.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace coppice::inline v0 {
namespace {

// Each of these builds on those before.
// clang-format off
#include "trace/kernels/lanes_scalar.inl"
#include "trace/kernels/decide_scalar.inl"
#include "trace/kernels/bvh8_trace.inl"
// clang-format on

}  // namespace

const TraceKernels& scalar_trace_kernels() noexcept {
    return kernels;
}

}  // namespace coppice::inline v0
