#include "trace/kernels/bvh8_trace.h"

namespace coppice::inline v0 {

bool decide_alone(const TriangleBlock& block, std::size_t lane, const Ray& ray, float t_max,
                  Hit& hit) noexcept {
    const auto found = TriangleTest(ray)(block.triangle(lane), t_max);
    if (!found) return false;
    hit = *found;
    hit.prim = block.id[lane];
    return true;
}

const TraceKernels& trace_kernels_for([[maybe_unused]] Isa isa) noexcept {
#if defined(__x86_64__)
    if (isa == Isa::avx512) return avx512_trace_kernels();
    if (isa == Isa::avx2) return avx2_trace_kernels();
    if (isa == Isa::sse42) return sse42_trace_kernels();
#endif
    return scalar_trace_kernels();
}

}  // namespace coppice::inline v0
