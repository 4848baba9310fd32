
#include "query/kernels/point_search.h"
#include "query/nearest_set.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace coppice::inline v0 {
namespace {

#include "query/kernels/point_search.inl"

}  // namespace

const PointSearchKernels& scalar_point_search_kernels() noexcept {
    return kernels;
}

}  // namespace coppice::inline v0
