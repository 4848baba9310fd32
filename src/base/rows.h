#pragma once

#include "base/batch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace coppice::inline v0 {

/// The length of the rows that `room` results for `count` queries make. Throws
/// Error(invalid_argument) naming the `query` if the room cannot be divided evenly.
[[nodiscard]] std::size_t row_length(std::string_view query, std::size_t count, std::size_t room);

/// Calls `run(i, row)` for the row of every query.
template <typename Found, typename Run>
void for_each_row(std::string_view query, std::size_t count, std::span<Found> found, int threads,
                  const Run& run) {
    const std::size_t room = row_length(query, count, found.size());
    for_each_query(count, threads, [&](std::size_t i) { run(i, found.subspan(i * room, room)); });
}

/// Calls `fill(i, row)`, which returns how many it found, for the row of every query, and fills the
/// rows up with default values.
template <typename Found, typename Fill>
void fill_rows(std::string_view query, std::size_t count, std::span<Found> found, int threads,
               const Fill& fill) {
    for_each_row(query, count, found, threads, [&](std::size_t i, std::span<Found> row) {
        const std::size_t found_count = fill(i, row);
        std::fill(row.begin() + static_cast<std::ptrdiff_t>(found_count), row.end(), Found{});
    });
}

/// Calls `visit_all(i, visit)`, which calls `visit` with all it finds, for every query; counts them
/// and writes them into the query's row as long as there is room.
template <typename Found, typename VisitAll>
void write_rows(std::string_view query, std::span<Found> found, std::span<std::size_t> counts,
                int threads, const VisitAll& visit_all) {
    for_each_row(query, counts.size(), found, threads, [&](std::size_t i, std::span<Found> row) {
        std::size_t count = 0;
        visit_all(i, [&](const Found& each) {
            if (count < row.size()) row[count] = each;
            ++count;
        });
        counts[i] = count;
    });
}

}  // namespace coppice::inline v0
