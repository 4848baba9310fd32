#include "coppice/geom/triangle.h"

#include "trace/kernels/wide_trace.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace coppice {
namespace {

#include "trace/kernels/lanes_scalar.inl"
#include "trace/kernels/wide_trace.inl"

}  // namespace

const TraceKernels& scalar_trace_kernels() noexcept {
    return kernels;
}

}  // namespace coppice
