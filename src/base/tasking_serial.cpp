// Implements coppice/base/parallel.h on the calling thread alone (COPPICE_TASKING=serial), for
// builds without oneTBB. Results equal those of the other backend, because they do not depend on
// the number of threads.

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"

#include <algorithm>

namespace coppice::inline v0 {
namespace {

/// A run_with_threads() that is active on this thread. A stop request of any of them cancels the
/// work inside it.
class Run {
public:
    explicit Run(const std::stop_token& stop) noexcept : stop_(stop), outer_(innermost) {
        innermost = this;
    }

    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    ~Run() { innermost = outer_; }

    [[nodiscard]] static bool is_stopped() noexcept {
        for (const Run* run = innermost; run != nullptr; run = run->outer_) {
            if (run->stop_.stop_requested()) return true;
        }
        return false;
    }

private:
    static thread_local const Run* innermost;

    const std::stop_token& stop_;
    const Run* outer_;
};

thread_local const Run* Run::innermost = nullptr;

}  // namespace

const char* tasking_backend() noexcept {
    return "serial";
}

int hardware_thread_count() noexcept {
    return 1;
}

void run_with_threads(int thread_count, const std::function<void()>& work,
                      const std::stop_token& stop) {
    require_thread_count(thread_count);
    const Run run(stop);
    throw_if_cancelled();
    work();
    throw_if_cancelled();
}

void throw_if_cancelled() {
    if (Run::is_stopped()) throw Error(ErrorCode::cancelled, "cancelled: a stop was requested");
}

void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second) {
    first();
    throw_if_cancelled();
    second();
    throw_if_cancelled();
}

void parallel_for_chunks(std::size_t count, std::size_t chunk_size,
                         const std::function<void(std::size_t, std::size_t)>& body) {
    for (std::size_t begin = 0; begin < count; begin += chunk_size) {
        body(begin, std::min(begin + chunk_size, count));
        throw_if_cancelled();
    }
}

void parallel_sort(std::span<std::uint64_t> values) {
    std::sort(values.begin(), values.end());
    throw_if_cancelled();
}

}  // namespace coppice::inline v0
