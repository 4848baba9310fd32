#include "base/rows.h"

#include "coppice/base/error.h"

#include <fmt/format.h>

namespace coppice::inline v0 {

std::size_t row_length(std::string_view query, std::size_t count, std::size_t room) {
    if (count == 0 ? room != 0 : room % count != 0) {
        throw Error(
            ErrorCode::invalid_argument,
            fmt::format(
                "{}: the number of results ({}) must be a multiple of the number of queries ({})",
                query, room, count));
    }
    return count == 0 ? 0 : room / count;
}

}  // namespace coppice::inline v0
