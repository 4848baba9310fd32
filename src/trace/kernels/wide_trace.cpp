#include "trace/kernels/wide_trace.h"

namespace coppice {

const TraceKernels& trace_kernels_for(Isa isa) noexcept {
    return isa == Isa::avx2 ? avx2_trace_kernels() : scalar_trace_kernels();
}

}  // namespace coppice
