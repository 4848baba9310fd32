#pragma once

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace coppice::inline v0 {

/// What oneTBB guarantees, for the thread sanitizer, which does not see into its library: all that
/// was done before a fork happens before its tasks, and all that its tasks did before those who
/// wait for them go on. Between two tasks it says nothing. Compiles to nothing elsewhere.
class ForkJoin {
public:
    ForkJoin() noexcept { release(&fork_); }

    ForkJoin(const ForkJoin&) = delete;
    ForkJoin& operator=(const ForkJoin&) = delete;

    ~ForkJoin() { acquire(&join_); }

    /// Lives as long as a task works.
    class Task {
    public:
        explicit Task(ForkJoin& of) noexcept : of_(of) { acquire(&of_.fork_); }

        Task(const Task&) = delete;
        Task& operator=(const Task&) = delete;

        ~Task() { release(&of_.join_); }

    private:
        ForkJoin& of_;
    };

private:
#if defined(__SANITIZE_THREAD__)
    static void acquire(char* mark) noexcept {
        __tsan_acquire(mark);
    }

    static void release(char* mark) noexcept {
        __tsan_release(mark);
    }
#else
    static void acquire(char* /*mark*/) noexcept {}

    static void release(char* /*mark*/) noexcept {}
#endif

    char fork_ = 0;  // their addresses are what counts
    char join_ = 0;
};

}  // namespace coppice::inline v0
