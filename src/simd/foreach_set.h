// Includes the header COPPICE_SIMD_KERNELS once for each instruction set: for the scalar set, and
// on x86-64 for the sets in COPPICE_SIMD_SETS, a sum of the numbers in set.h. The header must
// define a constant `kernels` in a namespace with the set's name. COPPICE_SIMD_TABLES then lists
// these constants for simd::Tables (dispatch.h). Usage:
//
//   #define COPPICE_SIMD_KERNELS "trace/kernels/bvh8_trace_set.h"
//   #define COPPICE_SIMD_SETS (COPPICE_SIMD_SSE42 + COPPICE_SIMD_AVX2)
//   #include "simd/foreach_set.h"
//
// Include it at most once in a source file. That file then holds the kernels of all sets, and must
// not be part of a unity build.
#pragma once

#if !defined(COPPICE_SIMD_KERNELS) || !defined(COPPICE_SIMD_SETS)
#error "define COPPICE_SIMD_KERNELS and COPPICE_SIMD_SETS first"
#endif

#include "simd/dispatch.h"
#include "simd/set.h"

#if !defined(__x86_64__)
#undef COPPICE_SIMD_SETS
#define COPPICE_SIMD_SETS 0
#endif

#undef COPPICE_SIMD_ISA
#define COPPICE_SIMD_ISA COPPICE_SIMD_SCALAR
#include COPPICE_SIMD_KERNELS

#if COPPICE_SIMD_SETS & COPPICE_SIMD_SSE42
#include "simd/toggle.h"
#undef COPPICE_SIMD_ISA
#define COPPICE_SIMD_ISA COPPICE_SIMD_SSE42
#include COPPICE_SIMD_KERNELS
#define COPPICE_SIMD_TABLE_SSE42 {Isa::sse42, &sse42::kernels},
#else
#define COPPICE_SIMD_TABLE_SSE42
#endif

#if COPPICE_SIMD_SETS & COPPICE_SIMD_AVX2
#include "simd/toggle.h"
#undef COPPICE_SIMD_ISA
#define COPPICE_SIMD_ISA COPPICE_SIMD_AVX2
#include COPPICE_SIMD_KERNELS
#define COPPICE_SIMD_TABLE_AVX2 {Isa::avx2, &avx2::kernels},
#else
#define COPPICE_SIMD_TABLE_AVX2
#endif

#if COPPICE_SIMD_SETS & COPPICE_SIMD_AVX512
#include "simd/toggle.h"
#undef COPPICE_SIMD_ISA
#define COPPICE_SIMD_ISA COPPICE_SIMD_AVX512
#include COPPICE_SIMD_KERNELS
#define COPPICE_SIMD_TABLE_AVX512 {Isa::avx512, &avx512::kernels},
#else
#define COPPICE_SIMD_TABLE_AVX512
#endif

// clang-format off
#define COPPICE_SIMD_TABLES                                                                        \
    {                                                                                              \
        {Isa::scalar, &scalar::kernels}, COPPICE_SIMD_TABLE_SSE42                                  \
        COPPICE_SIMD_TABLE_AVX2 COPPICE_SIMD_TABLE_AVX512                                          \
    }
// clang-format on
