#pragma once

#include <cstddef>

#ifdef COPPICE_TEST_HAS_TBB
#include <tbb/global_control.h>
#endif

namespace coppice::test {

#ifdef COPPICE_TEST_HAS_TBB

/// While one lives, work may run on so many threads, also on a machine of fewer.
class MoreThreads {
public:
    explicit MoreThreads(std::size_t count)
        : allowed_(tbb::global_control::max_allowed_parallelism, count) {}

private:
    tbb::global_control allowed_;
};

#else

/// Where tasks run serially there is one thread whatever is allowed.
class MoreThreads {
public:
    explicit MoreThreads(std::size_t /*count*/) {}
};

#endif

}  // namespace coppice::test
