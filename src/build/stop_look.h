#pragma once

#include "coppice/base/parallel.h"

#include <cstddef>

namespace coppice {

/// Looks for a stop now and then in a long loop of one task.
class StopLook {
public:
    /// Before or after the step of that number; throw_if_stopped() once in 65,536 steps.
    void at(std::size_t step) {
        if (step < next_) return;
        next_ = step + steps;
        throw_if_stopped();
    }

private:
    static constexpr std::size_t steps = 65536;
    std::size_t next_ = steps;
};

}  // namespace coppice
