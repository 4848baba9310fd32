#include "query/batch.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"

#include <fmt/format.h>

namespace coppice {
namespace {

constexpr std::size_t chunk_size = 256;  // queries; takes some tenths of a millisecond

}  // namespace

void for_each_query(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
    if (threads < 0) {
        throw Error(ErrorCode::invalid_argument, fmt::format("threads {} is less than 0", threads));
    }
    const auto run = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            body(i);
        }
    };
    if (threads == 1 || count <= chunk_size) {
        run(0, count);
    } else {
        run_with_threads(threads, [&] { parallel_for_chunks(count, chunk_size, run); });
    }
}

std::size_t row_length(std::string_view query, std::size_t count, std::size_t room) {
    if (count == 0 ? room != 0 : room % count != 0) {
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("{}: room for {} results cannot be divided among {} queries", query,
                                room, count));
    }
    return count == 0 ? 0 : room / count;
}

void require_room(std::string_view query, std::size_t count, std::size_t room) {
    if (count == room) return;
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{}: {} queries, but room for {} results", query, count, room));
}

}  // namespace coppice
