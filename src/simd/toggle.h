// Starts the next instruction set: reopens the include guards of kernel headers (set.h). Has no
// include guard itself.

#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_SIMD_TOGGLE
#else
#define COPPICE_SIMD_TOGGLE
#endif
