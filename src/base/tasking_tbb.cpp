// Implements coppice/base/parallel.h with oneTBB (COPPICE_TASKING=tbb). No other source depends on
// oneTBB.
//
// When a oneTBB task group is cancelled, oneTBB cancels all groups below it. Its algorithms then
// return early without an exception. Hence each call of one is followed by throw_if_cancelled().

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"

#include "base/fork_join.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>
#include <tbb/task.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>

namespace coppice::inline v0 {
namespace {

Error stopped() {
    return {ErrorCode::cancelled, "cancelled: a stop was requested"};
}

void run_until_stopped(const std::function<void()>& work, const std::stop_token& stop) {
    tbb::task_group_context context;
    const std::stop_callback cancel(stop, [&] { context.cancel_group_execution(); });
    tbb::task_group group(context);
    if (group.run_and_wait(work) == tbb::canceled) throw stopped();
}

}  // namespace

const char* tasking_backend() noexcept {
    return "tbb";
}

int hardware_thread_count() noexcept {
    return std::max(1, tbb::info::default_concurrency());
}

void run_with_threads(int thread_count, const std::function<void()>& work,
                      const std::stop_token& stop) {
    require_thread_count(thread_count);
    // oneTBB uses no more threads than the hardware has, unless a program raises that limit, and
    // prints a warning if asked for more.
    const int available = hardware_thread_count();
    const auto allowed = static_cast<int>(
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    tbb::task_arena arena(thread_count > 0 ? std::min(thread_count, std::max(available, allowed))
                                           : available);
    ForkJoin all;
    const auto run = [&] {
        const ForkJoin::Task task(all);
        work();
    };
    if (stop.stop_possible()) {
        arena.execute([&] { run_until_stopped(run, stop); });
    } else {
        arena.execute(run);
    }
}

void throw_if_cancelled() {
    if (tbb::is_current_task_group_canceling()) throw stopped();
}

// Contexts are constructed before the ForkJoin, because tasks read them in throw_if_cancelled().
void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second) {
    tbb::task_group_context context;
    ForkJoin both;
    const auto run = [&both](const std::function<void()>& work) {
        const ForkJoin::Task task(both);
        work();
    };
    tbb::parallel_invoke([&] { run(first); }, [&] { run(second); }, context);
    throw_if_cancelled();
}

void parallel_for_chunks(std::size_t count, std::size_t chunk_size,
                         const std::function<void(std::size_t, std::size_t)>& body) {
    const std::size_t chunk_count = (count + chunk_size - 1) / chunk_size;
    tbb::task_group_context context;
    ForkJoin all;
    const auto run = [&](std::size_t chunk) {
        const ForkJoin::Task task(all);
        const std::size_t begin = chunk * chunk_size;
        body(begin, std::min(begin + chunk_size, count));
    };
    tbb::parallel_for(std::size_t{0}, chunk_count, run, context);
    throw_if_cancelled();
}

void parallel_sort(std::span<std::uint64_t> values) {
    constexpr std::size_t few = 4096;  // for fewer, tasks cost more than they save
    if (values.size() < few) {
        std::sort(values.begin(), values.end());
    } else {
        tbb::parallel_sort(values.begin(), values.end());
        throw_if_cancelled();
    }
}

}  // namespace coppice::inline v0
