#pragma once

#include "coppice/export.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>

namespace coppice::inline v0 {

/// The tasking backend of this build of the library: "tbb", or "serial", which uses one thread
/// whatever number is requested.
[[nodiscard]] COPPICE_EXPORT const char* tasking_backend() noexcept;

/// The number of hardware threads that this process may use; at least 1. It is 1 with the serial
/// backend.
[[nodiscard]] COPPICE_EXPORT int hardware_thread_count() noexcept;

/// Throws Error(invalid_argument) if `thread_count` is negative. Every thread count in this library
/// is an upper limit, and 0 stands for all hardware threads.
COPPICE_EXPORT void require_thread_count(int thread_count);

/// Runs `work`; everything parallel inside it uses at most `thread_count` threads (0 = all hardware
/// threads). Throws Error(invalid_argument) if `thread_count` is negative. Exceptions of `work`
/// reach the caller. Once `stop` is requested, no further task starts, running tasks end at their
/// next throw_if_cancelled(), and Error(cancelled) is thrown.
COPPICE_EXPORT void run_with_threads(int thread_count, const std::function<void()>& work,
                                     const std::stop_token& stop = {});

/// Throws Error(cancelled) if the surrounding parallel work is being cancelled, because a stop was
/// requested or because another of its tasks threw. Costs a few nanoseconds. All functions below
/// call it before they return, so that a caller never sees a partial result.
COPPICE_EXPORT void throw_if_cancelled();

/// Runs both tasks, possibly at the same time. Returns when both have finished.
COPPICE_EXPORT void parallel_invoke(const std::function<void()>& first,
                                    const std::function<void()>& second);

/// Calls `body(begin, end)` for disjoint chunks of at most `chunk_size` elements that together
/// cover [0, count). Chunk boundaries are multiples of `chunk_size` and do not depend on the number
/// of threads.
COPPICE_EXPORT void parallel_for_chunks(std::size_t count, std::size_t chunk_size,
                                        const std::function<void(std::size_t, std::size_t)>& body);

/// Sorts numbers in ascending order; in parallel if there are more than a few thousand.
COPPICE_EXPORT void parallel_sort(std::span<std::uint64_t> values);

}  // namespace coppice::inline v0
