#pragma once

/// Between COPPICE_BEGIN_AVX2 and COPPICE_END_ISA functions are compiled for AVX2 and FMA, and the
/// like. Headers are included before, so that no inline function of theirs is: the linker may keep
/// any copy of such a function for the whole program.
#define COPPICE_PRAGMA(words) _Pragma(#words)
#if defined(__clang__)
#define COPPICE_BEGIN_ISA(sets) \
    COPPICE_PRAGMA(clang attribute push(__attribute__((target(sets))), apply_to = function))
#define COPPICE_END_ISA COPPICE_PRAGMA(clang attribute pop)
#else
#define COPPICE_BEGIN_ISA(sets) COPPICE_PRAGMA(GCC push_options) COPPICE_PRAGMA(GCC target(sets))
#define COPPICE_END_ISA COPPICE_PRAGMA(GCC pop_options)
#endif

#define COPPICE_BEGIN_SSE42 COPPICE_BEGIN_ISA("sse4.2")
#define COPPICE_BEGIN_AVX2 COPPICE_BEGIN_ISA("avx2,fma")
#define COPPICE_BEGIN_AVX512 COPPICE_BEGIN_ISA("avx2,fma,avx512vl,avx512dq")
