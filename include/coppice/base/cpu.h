#pragma once

#include "coppice/export.h"

#include <span>
#include <string_view>

namespace coppice::inline v0 {

/// Instruction sets that the kernels are compiled for, each with those before it. All give the same
/// trees and the same hits.
enum class Isa {
    scalar,  ///< what every processor of the architecture has
    sse42,   ///< SSE4.2 (x86-64), by which only the 8-wide tree is traced otherwise than by scalar
    avx2,    ///< AVX2 and FMA (x86-64)
    avx512   ///< and AVX-512VL and DQ, by which only the 8-wide tree is traced otherwise than by
             ///< avx2
};

/// The stable lower-case name, e.g. "sse4.2".
[[nodiscard]] COPPICE_EXPORT std::string_view name_of(Isa isa) noexcept;

/// Those this processor can run, the slowest first; never none.
[[nodiscard]] COPPICE_EXPORT std::span<const Isa> available_isas() noexcept;

/// The fastest available one, or the one that the environment variable COPPICE_ISA names, in any
/// case and with or without dots. Throws Error(invalid_argument) if that names none, or one this
/// processor does not have.
[[nodiscard]] COPPICE_EXPORT Isa choose_isa();

}  // namespace coppice::inline v0
