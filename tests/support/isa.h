#pragma once

#include "coppice/base/cpu.h"

#include <cstdlib>
#include <string>

namespace coppice::test {

/// While one lives, COPPICE_ISA names an instruction set.
class ForceIsa {
public:
    explicit ForceIsa(Isa isa) { setenv("COPPICE_ISA", std::string(name_of(isa)).c_str(), 1); }

    ForceIsa(const ForceIsa&) = delete;
    ForceIsa& operator=(const ForceIsa&) = delete;

    ~ForceIsa() { unsetenv("COPPICE_ISA"); }
};

}  // namespace coppice::test
