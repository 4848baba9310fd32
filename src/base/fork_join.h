#pragma once

#if defined(__has_feature)  // clang's way to tell
#if __has_feature(thread_sanitizer)
#define COPPICE_THREAD_SANITIZER
#endif
#elif defined(__SANITIZE_THREAD__)  // and g++'s
#define COPPICE_THREAD_SANITIZER
#endif

#if defined(COPPICE_THREAD_SANITIZER)
#include <sanitizer/tsan_interface.h>
#endif

namespace coppice::inline v0 {

/// Tells the thread sanitizer what oneTBB guarantees, because the sanitizer cannot see into the
/// library. All that was done before the fork happens before the tasks. All that the tasks did
/// happens before the code that waits for them continues. Nothing is said about the order of two
/// tasks. Without the thread sanitizer it compiles to nothing.
class ForkJoin {
public:
    ForkJoin() noexcept { release(&fork_); }

    ForkJoin(const ForkJoin&) = delete;
    ForkJoin& operator=(const ForkJoin&) = delete;

    ~ForkJoin() { acquire(&join_); }

    /// Create one at the start of each task; it must live until the task ends.
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
#if defined(COPPICE_THREAD_SANITIZER)
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

    char fork_ = 0;  // only the addresses matter
    char join_ = 0;
};

}  // namespace coppice::inline v0
