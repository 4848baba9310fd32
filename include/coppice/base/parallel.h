#pragma once

#include "coppice/export.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>

namespace coppice::inline v0 {

/// What runs tasks in this build of the library: "tbb", or "serial", where every number of threads
/// means one.
[[nodiscard]] COPPICE_EXPORT const char* tasking_backend() noexcept;

/// The number of hardware threads this process may use; at least 1, and 1 where tasks run serially.
[[nodiscard]] COPPICE_EXPORT int hardware_thread_count() noexcept;

/// The rule for every number of threads in this library: at most so many, and 0 for all that the
/// hardware has. Throws Error(invalid_argument) if it is negative.
COPPICE_EXPORT void require_thread_count(int thread_count);

/// Runs `work` with at most `thread_count` threads for everything parallel inside it
/// (0 = all the hardware has). Throws Error(invalid_argument) if it is negative. Exceptions of
/// `work` reach the caller. Once a stop is requested, no task inside begins any more, those that
/// run end at their next throw_if_cancelled(), and Error(cancelled) is thrown.
COPPICE_EXPORT void run_with_threads(int thread_count, const std::function<void()>& work,
                                     const std::stop_token& stop = {});

/// Throws Error(cancelled) if the parallel work that this is part of is being given up, because a
/// stop was requested or another task of it threw; takes a few nanoseconds. All functions below do
/// so when they are done: who gets past them has all of the result.
COPPICE_EXPORT void throw_if_cancelled();

/// Runs both tasks, possibly at the same time, and returns when both are done.
COPPICE_EXPORT void parallel_invoke(const std::function<void()>& first,
                                    const std::function<void()>& second);

/// Calls `body(begin, end)` on disjoint chunks of at most `chunk_size` that cover [0, count).
/// Chunk boundaries are multiples of `chunk_size`, whatever the number of threads.
COPPICE_EXPORT void parallel_for_chunks(std::size_t count, std::size_t chunk_size,
                                        const std::function<void(std::size_t, std::size_t)>& body);

/// Sorts numbers in ascending order, in parallel where there are many.
COPPICE_EXPORT void parallel_sort(std::span<std::uint64_t> values);

}  // namespace coppice::inline v0
