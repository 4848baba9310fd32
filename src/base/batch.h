#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace coppice::inline v0 {

/// Throws Error(invalid_argument) naming `query` unless `room` equals `count`: one result for each
/// query.
void require_room(std::string_view query, std::size_t count, std::size_t room);

/// Calls `run(begin, end)` for ranges that together cover [0, count), on at most `threads` threads
/// (0 = all hardware threads). Throws Error(invalid_argument) if `threads` is negative, and
/// Error(out_of_memory) if there is no memory for the tasks.
void run_query_ranges(std::size_t count, int threads,
                      const std::function<void(std::size_t, std::size_t)>& run);

/// run_query_ranges() without copying `run`.
template <typename Run>
void run_queries(std::size_t count, int threads, const Run& run) {
    run_query_ranges(count, threads, std::cref(run));
}

/// Calls `body(i)` for all i < count, on threads as run_query_ranges() uses them.
template <typename Body>
void for_each_query(std::size_t count, int threads, const Body& body) {
    run_queries(count, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            body(i);
        }
    });
}

}  // namespace coppice::inline v0
