#pragma once

/// Between COPPICE_BEGIN_AVX2 and COPPICE_END_ISA functions are compiled for AVX2 and FMA, and the
/// like. Headers are included before, so that no inline function of theirs is: the linker may keep
/// any copy of such a function for the whole program.
#if defined(__clang__)
#define COPPICE_BEGIN_SSE42 \
    _Pragma("clang attribute push(__attribute__((target(\"sse4.2\"))), apply_to = function)")
#define COPPICE_BEGIN_AVX2 \
    _Pragma("clang attribute push(__attribute__((target(\"avx2,fma\"))), apply_to = function)")
#define COPPICE_BEGIN_AVX512                                                             \
    _Pragma(                                                                             \
        "clang attribute push(__attribute__((target(\"avx2,fma,avx512vl,avx512dq\"))), " \
        "apply_to = function)")
#define COPPICE_END_ISA _Pragma("clang attribute pop")
#else
#define COPPICE_BEGIN_SSE42 _Pragma("GCC push_options") _Pragma("GCC target(\"sse4.2\")")
#define COPPICE_BEGIN_AVX2 _Pragma("GCC push_options") _Pragma("GCC target(\"avx2,fma\")")
#define COPPICE_BEGIN_AVX512 \
    _Pragma("GCC push_options") _Pragma("GCC target(\"avx2,fma,avx512vl,avx512dq\")")
#define COPPICE_END_ISA _Pragma("GCC pop_options")
#endif
