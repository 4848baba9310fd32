#pragma once

/// Between COPPICE_BEGIN_AVX2 and COPPICE_END_AVX2 functions are compiled for AVX2 and FMA. Headers
/// are included before, so that no inline function of theirs is: the linker may keep any copy of
/// such a function for the whole program.
#if defined(__clang__)
#define COPPICE_BEGIN_AVX2 \
    _Pragma("clang attribute push(__attribute__((target(\"avx2,fma\"))), apply_to = function)")
#define COPPICE_END_AVX2 _Pragma("clang attribute pop")
#else
#define COPPICE_BEGIN_AVX2 _Pragma("GCC push_options") _Pragma("GCC target(\"avx2,fma\")")
#define COPPICE_END_AVX2 _Pragma("GCC pop_options")
#endif
