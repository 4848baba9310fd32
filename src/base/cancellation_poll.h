#pragma once

#include "coppice/base/parallel.h"

#include <cstddef>

namespace coppice::inline v0 {

/// Checks for cancellation at intervals in a long loop of one task.
class CancellationPoll {
public:
    /// Call it once for each step, with the step's number. Calls throw_if_cancelled() once in
    /// 65,536 steps.
    void at(std::size_t step) {
        if (step < next_) return;
        next_ = step + steps;
        throw_if_cancelled();
    }

private:
    static constexpr std::size_t steps = 65536;
    std::size_t next_ = steps;
};

}  // namespace coppice::inline v0
