#pragma once

#include <tbb/global_control.h>

#include <cstddef>

namespace coppice::test {

/// While one lives, work may run on so many threads, also on a machine of fewer.
class MoreThreads {
public:
    explicit MoreThreads(std::size_t count)
        : allowed_(tbb::global_control::max_allowed_parallelism, count) {}

private:
    tbb::global_control allowed_;
};

}  // namespace coppice::test
