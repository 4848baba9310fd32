#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace coppice {

/// The number of hardware threads this process may use; at least 1.
[[nodiscard]] int hardware_thread_count() noexcept;

/// Runs `work` with at most `thread_count` threads for everything parallel inside it
/// (0 = all hardware threads). Exceptions of `work` reach the caller.
void run_with_threads(int thread_count, const std::function<void()>& work);

/// Runs both tasks, possibly at the same time, and returns when both are done.
void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second);

/// Calls `body(begin, end)` on disjoint chunks of at most `chunk_size` that cover [0, count).
/// Chunk boundaries are multiples of `chunk_size`, whatever the number of threads.
void parallel_for_chunks(std::size_t count, std::size_t chunk_size,
                         const std::function<void(std::size_t, std::size_t)>& body);

/// Sorts numbers in ascending order, in parallel where there are many.
void parallel_sort(std::span<std::uint64_t> values);

}  // namespace coppice
