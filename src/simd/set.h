// Defines macros for the instruction set that the following code is compiled for. A kernel header
// is included once for each set (foreach_set.h) and has this form:
//
//   #include "simd/set.h"
//   #if defined(COPPICE_THIS_HEADER_H) == defined(COPPICE_SIMD_TOGGLE)
//   #ifdef COPPICE_SIMD_TOGGLE
//   #undef COPPICE_THIS_HEADER_H
//   #else
//   #define COPPICE_THIS_HEADER_H
//   #endif
//   #include ...
//   COPPICE_SIMD_BEGIN
//   namespace coppice::inline v0 { namespace { namespace COPPICE_SIMD_SET { ... } } }
//   COPPICE_SIMD_END
//   #endif
//
// Its first lines are an include guard for each set: foreach_set.h defines COPPICE_SIMD_TOGGLE for
// every second set. A kernel header included by itself is compiled for the scalar set. This file
// has no include guard, because its macros change with COPPICE_SIMD_ISA.

#include "simd/target.h"

#define COPPICE_SIMD_SCALAR 1
#define COPPICE_SIMD_SSE42 2
#define COPPICE_SIMD_AVX2 4
#define COPPICE_SIMD_AVX512 8

#ifndef COPPICE_SIMD_ISA
#define COPPICE_SIMD_ISA COPPICE_SIMD_SCALAR
#endif

#undef COPPICE_SIMD_SET    // the namespace of the set's lanes, and of kernels on them
#undef COPPICE_SIMD_LANES  // the header with the set's lanes
#undef COPPICE_SIMD_BEGIN
#undef COPPICE_SIMD_END

#if COPPICE_SIMD_ISA == COPPICE_SIMD_SCALAR
#define COPPICE_SIMD_SET scalar
#define COPPICE_SIMD_LANES "simd/lanes_scalar.h"
#define COPPICE_SIMD_BEGIN
#define COPPICE_SIMD_END
#elif COPPICE_SIMD_ISA == COPPICE_SIMD_SSE42
#define COPPICE_SIMD_SET sse42
#define COPPICE_SIMD_LANES "simd/lanes_sse42.h"
#define COPPICE_SIMD_BEGIN COPPICE_TARGET_SSE42
#define COPPICE_SIMD_END COPPICE_TARGET_END
#elif COPPICE_SIMD_ISA == COPPICE_SIMD_AVX2
#define COPPICE_SIMD_SET avx2
#define COPPICE_SIMD_LANES "simd/lanes_avx2.h"
#define COPPICE_SIMD_BEGIN COPPICE_TARGET_AVX2
#define COPPICE_SIMD_END COPPICE_TARGET_END
#elif COPPICE_SIMD_ISA == COPPICE_SIMD_AVX512
#define COPPICE_SIMD_SET avx512
#define COPPICE_SIMD_LANES "simd/lanes_avx512.h"
#define COPPICE_SIMD_BEGIN COPPICE_TARGET_AVX512
#define COPPICE_SIMD_END COPPICE_TARGET_END
#endif
