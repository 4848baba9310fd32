#include "builders/kernels/bvh8_kernels.h"

#include "builders/kernels/bvh8_kernels_sets.h"

namespace coppice::inline v0::bvh8 {

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

}  // namespace coppice::inline v0::bvh8
