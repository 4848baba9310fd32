#pragma once

/// Exports a declaration from a shared library of coppice; everything else in it is hidden. Static
/// libraries are compiled and used with COPPICE_STATIC, so that a library that contains coppice
/// does not export it.
#if defined(COPPICE_STATIC)
#define COPPICE_EXPORT
#else
#define COPPICE_EXPORT __attribute__((visibility("default")))
#endif
