#pragma once

#include <cstdio>
#include <cstdlib>

namespace coppice::fuzz {

/// Ends the program, which the fuzzer takes for a finding, unless `holds`.
inline void expect(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "expected: %s\n", what);
    std::abort();
}

}  // namespace coppice::fuzz
