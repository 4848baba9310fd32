#pragma once

#include "build/kernels/wide_kernels.h"

namespace coppice::wide {

/// The kernels of each instruction set; see kernels_for().
[[nodiscard]] const Kernels& scalar_kernels() noexcept;
[[nodiscard]] const Kernels& avx2_kernels() noexcept;

}  // namespace coppice::wide
