#include "trace/kernels/wide_trace.h"

namespace coppice {

bool decide_alone(const TriangleBlock& block, std::size_t lane, const Ray& ray, float t_max,
                  Hit& hit) noexcept {
    const auto found = TriangleTest(ray)(block.triangle(lane), t_max);
    if (!found) return false;
    hit = *found;
    hit.prim = block.id[lane];
    return true;
}

const TraceKernels& trace_kernels_for(Isa isa) noexcept {
    return isa == Isa::avx2 ? avx2_trace_kernels() : scalar_trace_kernels();
}

}  // namespace coppice
