// The next instruction set begins: include guards of kernels' headers open again (set.h). No guard.

#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_SIMD_TOGGLE
#else
#define COPPICE_SIMD_TOGGLE
#endif
