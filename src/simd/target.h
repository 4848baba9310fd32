#pragma once

/// Functions between COPPICE_TARGET_AVX2 and COPPICE_TARGET_END are compiled for AVX2 and FMA;
/// likewise for the other sets. Include other headers before. Otherwise their inline functions
/// would be compiled for AVX2, too, and the linker might keep that copy for the whole program.
#define COPPICE_PRAGMA(words) _Pragma(#words)
#if defined(__clang__)
#define COPPICE_TARGET(sets) \
    COPPICE_PRAGMA(clang attribute push(__attribute__((target(sets))), apply_to = function))
#define COPPICE_TARGET_END COPPICE_PRAGMA(clang attribute pop)
#else
#define COPPICE_TARGET(sets) COPPICE_PRAGMA(GCC push_options) COPPICE_PRAGMA(GCC target(sets))
#define COPPICE_TARGET_END COPPICE_PRAGMA(GCC pop_options)
#endif

#define COPPICE_TARGET_SSE42 COPPICE_TARGET("sse4.2")
#define COPPICE_TARGET_AVX2 COPPICE_TARGET("avx2,fma")
#define COPPICE_TARGET_AVX512 COPPICE_TARGET("avx2,fma,avx512vl,avx512dq")

/// Marks an operation on lanes. It is always inlined, so that no vector is passed in memory.
#define COPPICE_LANES [[gnu::always_inline]] inline
