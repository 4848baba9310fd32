#include "builders/kernels/bvh8_kernels_sets.h"

#include <algorithm>

namespace coppice::inline v0::bvh8 {
namespace {

#include "builders/kernels/lanes_scalar.inl"
#include "builders/kernels/object_kernels.inl"

}  // namespace

const Kernels& scalar_kernels() noexcept {
    return kernels;
}

}  // namespace coppice::inline v0::bvh8
