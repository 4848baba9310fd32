#pragma once

#include "builders/kernels/bvh8_kernels.h"

namespace coppice::inline v0::bvh8 {

/// The kernels of each instruction set; see kernels_for().
[[nodiscard]] const Kernels& scalar_kernels() noexcept;
[[nodiscard]] const Kernels& avx2_kernels() noexcept;

}  // namespace coppice::inline v0::bvh8
