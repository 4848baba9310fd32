#pragma once

#include <cstddef>

#ifdef COPPICE_TEST_HAS_TBB
#include <tbb/global_control.h>
#include <tbb/task_scheduler_observer.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>
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

/// The threads that take part in the work of the caller's arena, from the construction on.
class ThreadsTakingPart : public tbb::task_scheduler_observer {
public:
    ThreadsTakingPart() { observe(true); }

    ThreadsTakingPart(const ThreadsTakingPart&) = delete;
    ThreadsTakingPart& operator=(const ThreadsTakingPart&) = delete;

    ~ThreadsTakingPart() override { observe(false); }

    void on_scheduler_entry(bool /*is_worker*/) override {
        const std::scoped_lock lock(mutex_);
        threads_.insert(std::this_thread::get_id());
        joined_.notify_all();
    }

    /// How many there are; waits for at most 20 ms until there are `expected`.
    std::size_t count(std::size_t expected = 0) {
        std::unique_lock lock(mutex_);
        joined_.wait_for(lock, std::chrono::milliseconds(20),
                         [&] { return threads_.size() >= expected; });
        return threads_.size();
    }

private:
    std::mutex mutex_;
    std::condition_variable joined_;
    std::set<std::thread::id> threads_;
};

#else

/// Where tasks run serially there is one thread whatever is allowed.
class MoreThreads {
public:
    explicit MoreThreads(std::size_t /*count*/) {}
};

#endif

}  // namespace coppice::test
