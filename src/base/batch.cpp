#include "base/batch.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"

#include "base/out_of_memory.h"

#include <fmt/format.h>

namespace coppice::inline v0 {

void require_room(std::string_view query, std::size_t count, std::size_t room) {
    if (count == room) return;
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{}: the number of results ({}) must equal the number of queries ({})",
                            query, room, count));
}

void run_query_ranges(std::size_t count, int threads,
                      const std::function<void(std::size_t, std::size_t)>& run) {
    // Large enough to outweigh the cost of a task, small enough to balance the load.
    constexpr std::size_t chunk_size = 512;
    require_thread_count(threads);
    if (threads == 1 || count <= chunk_size) {
        run(0, count);
    } else {
        with_memory_errors("the queries", [&] {
            run_with_threads(threads, [&] { parallel_for_chunks(count, chunk_size, run); });
        });
    }
}

}  // namespace coppice::inline v0
