#include "query/kernels/mesh_search.h"

#if defined(__x86_64__)

#include "coppice/geom/closest_point.h"
#include "coppice/geom/overlap.h"

#include "base/isa.h"
#include "query/nearest_set.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace coppice::inline v0 {

COPPICE_BEGIN_AVX2

namespace {

#include "query/kernels/mesh_bounds.inl"
#include "query/kernels/mesh_search.inl"

}  // namespace

COPPICE_END_ISA

const MeshSearchKernels& avx2_mesh_search_kernels() noexcept {
    return kernels;
}

}  // namespace coppice::inline v0

#endif
