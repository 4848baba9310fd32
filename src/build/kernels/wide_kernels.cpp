#include "build/kernels/wide_kernels.h"

#include "build/kernels/wide_kernels_sets.h"

namespace coppice::wide {

const Kernels& kernels_for([[maybe_unused]] Isa isa) noexcept {
#if defined(__x86_64__)
    if (isa >= Isa::avx2) return avx2_kernels();
#endif
    return scalar_kernels();
}

void clear(Bins& bins, std::uint32_t bin_count) noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::uint32_t bin = 0; bin < bin_count; ++bin) {
            bins.box[axis][bin] = Box8::make_empty();
            bins.weight[axis][bin] = 0.0F;
        }
    }
}

}  // namespace coppice::wide
