#pragma once

#include "base/batch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace coppice::inline v0 {

/// The number of results per query (the length of a row) if `count` queries share `room` results.
/// Throws Error(invalid_argument) naming `query` if `room` is not a multiple of `count`.
[[nodiscard]] std::size_t row_length(std::string_view query, std::size_t count, std::size_t room);

/// Calls `run(i, row)` for every query i and its row.
template <typename Found, typename Run>
void for_each_row(std::string_view query, std::size_t count, std::span<Found> found, int threads,
                  const Run& run) {
    const std::size_t room = row_length(query, count, found.size());
    for_each_query(count, threads, [&](std::size_t i) { run(i, found.subspan(i * room, room)); });
}

/// Calls `fill(i, row)` for every query i. `fill` returns the number of results it wrote; the rest
/// of the row is filled with default values.
template <typename Found, typename Fill>
void fill_rows(std::string_view query, std::size_t count, std::span<Found> found, int threads,
               const Fill& fill) {
    for_each_row(query, count, found, threads, [&](std::size_t i, std::span<Found> row) {
        const std::size_t found_count = fill(i, row);
        std::fill(row.begin() + static_cast<std::ptrdiff_t>(found_count), row.end(), Found{});
    });
}

/// Calls `visit_all(i, visit)` for every query i, which calls `visit` for each of its results.
/// Counts the results and writes the first of them into the query's row, as many as fit.
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
