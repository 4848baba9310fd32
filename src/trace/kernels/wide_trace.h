#pragma once

#include "coppice/base/cpu.h"
#include "coppice/geom/ray.h"
#include "coppice/tree/wide_bvh.h"

namespace coppice {

/// The traversals of a wide tree for one instruction set. They return whether there is a hit and
/// fill it in.
struct TraceKernels {
    bool (*closest)(const WideBvh&, const Ray&, Hit&) noexcept;
    bool (*any)(const WideBvh&, const Ray&, Hit&) noexcept;
};

/// The traversals for an instruction set that this processor has.
[[nodiscard]] const TraceKernels& trace_kernels_for(Isa isa) noexcept;

/// Those of each set.
[[nodiscard]] const TraceKernels& scalar_trace_kernels() noexcept;
[[nodiscard]] const TraceKernels& avx2_trace_kernels() noexcept;

}  // namespace coppice
