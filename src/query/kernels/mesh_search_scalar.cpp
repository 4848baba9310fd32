#include "coppice/geom/closest_point.h"
#include "coppice/geom/overlap.h"

#include "query/kernels/mesh_search.h"
#include "query/nearest_set.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace coppice::inline v0 {
namespace {

#include "query/kernels/mesh_bounds.inl"
#include "query/kernels/mesh_search.inl"

}  // namespace

const MeshSearchKernels& scalar_mesh_search_kernels() noexcept {
    return kernels;
}

}  // namespace coppice::inline v0
