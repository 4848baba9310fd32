#pragma once

#include "coppice/export.h"

/// The version of these headers. version() returns that of the library a program runs with.
#define COPPICE_VERSION_MAJOR 0
#define COPPICE_VERSION_MINOR 1
#define COPPICE_VERSION_PATCH 0

/// The version as one number for comparisons: 10203 is 1.2.3.
#define COPPICE_VERSION \
    (COPPICE_VERSION_MAJOR * 10000 + COPPICE_VERSION_MINOR * 100 + COPPICE_VERSION_PATCH)

namespace coppice::inline v0 {

/// The version of a library.
struct Version {
    int major;         ///< raised by what breaks programs, from 1.0 on
    int minor;         ///< before 1.0 raised by what breaks programs
    int patch;         ///< raised by corrections
    const char* text;  ///< "1.2.3"
};

/// The version of the library that is running. A shared library may be newer than the headers.
[[nodiscard]] COPPICE_EXPORT Version version() noexcept;

}  // namespace coppice::inline v0
