#pragma once

#include "coppice/export.h"

#include <span>
#include <string_view>

namespace coppice::inline v0 {

/// The instruction sets that the kernels are compiled for. Each one includes those before it. All
/// give the same trees and the same hits.
enum class Isa {
    scalar,  ///< no vector instructions; every processor has it
    sse42,   ///< SSE4.2 (x86-64); only the traversal of Bvh8 differs from scalar
    avx2,    ///< AVX2 and FMA (x86-64)
    avx512   ///< AVX2, AVX-512VL and AVX-512DQ (x86-64); only the traversal of Bvh8 differs from
             ///< avx2.
};

/// The stable lower-case name of an instruction set, e.g. "sse4.2".
[[nodiscard]] COPPICE_EXPORT std::string_view name_of(Isa isa) noexcept;

/// The instruction sets that this processor can run, the slowest first. Never empty: `scalar` is
/// always available.
[[nodiscard]] COPPICE_EXPORT std::span<const Isa> available_isas() noexcept;

/// The instruction set to use: the one that the environment variable COPPICE_ISA names, in any case
/// and with or without dots, else the fastest available one. Throws Error(invalid_argument) if
/// COPPICE_ISA names no instruction set that this processor has.
[[nodiscard]] COPPICE_EXPORT Isa choose_isa();

}  // namespace coppice::inline v0
