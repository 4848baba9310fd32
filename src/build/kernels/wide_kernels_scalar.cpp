#include "build/kernels/wide_kernels_sets.h"

#include <algorithm>

namespace coppice::wide {
namespace {

#include "build/kernels/lanes_scalar.inl"
#include "build/kernels/wide_kernels.inl"

}  // namespace

const Kernels& scalar_kernels() noexcept {
    return kernels;
}

}  // namespace coppice::wide
