#pragma once

/// Marks what a shared library of coppice offers; all else in it is hidden. Static libraries are
/// compiled and used with COPPICE_STATIC, so that a library they are linked into does not offer it.
#if defined(COPPICE_STATIC)
#define COPPICE_EXPORT
#else
#define COPPICE_EXPORT __attribute__((visibility("default")))
#endif
