#pragma once

#include "coppice/base/cpu.h"

#include <array>
#include <cstddef>
#include <initializer_list>

namespace coppice::inline v0::simd {

/// The kernels of one module for every instruction set that they are compiled for. Selects among
/// them at run time.
template <typename Kernels>
class Tables {
public:
    struct Table {
        Isa isa;
        const Kernels* kernels;
    };

    /// Takes COPPICE_SIMD_TABLES (foreach_set.h): tables in the order of Isa, the scalar one first.
    constexpr Tables(std::initializer_list<Table> tables) noexcept {
        for (const Table& table : tables) {
            for (auto isa = static_cast<std::size_t>(table.isa); isa < best_.size(); ++isa) {
                best_[isa] = table.kernels;
            }
        }
    }

    /// The kernels of `isa`, or of the best set below it if there are none. The processor must
    /// support `isa`.
    [[nodiscard]] const Kernels& at(Isa isa) const noexcept {
        return *best_[static_cast<std::size_t>(isa)];
    }

private:
    static constexpr std::size_t isa_count = static_cast<std::size_t>(Isa::avx512) + 1;

    std::array<const Kernels*, isa_count> best_{};
};

}  // namespace coppice::inline v0::simd
