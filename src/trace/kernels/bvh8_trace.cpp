#include "trace/kernels/bvh8_trace.h"

#define COPPICE_SIMD_KERNELS "trace/kernels/bvh8_trace_set.h"
#define COPPICE_SIMD_SETS (COPPICE_SIMD_SSE42 + COPPICE_SIMD_AVX2 + COPPICE_SIMD_AVX512)
#include "simd/foreach_set.h"

namespace coppice::inline v0 {

bool decide_alone(const TriangleBlock& block, std::size_t lane, const Ray& ray, float t_max,
                  Hit& hit) noexcept {
    const auto found = TriangleTest(ray)(block.triangle(lane), t_max);
    if (!found) return false;
    hit = *found;
    hit.prim = block.id[lane];
    return true;
}

const TraceKernels& trace_kernels_for(Isa isa) noexcept {
    static constexpr simd::Tables<TraceKernels> tables COPPICE_SIMD_TABLES;
    return tables.at(isa);
}

}  // namespace coppice::inline v0
