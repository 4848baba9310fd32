#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

namespace coppice {

/// Calls `body(i)` for all i < count, on at most `threads` threads (0 = all the hardware has).
void for_each_query(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

/// The length of the rows that `room` results for `count` queries make. Throws
/// Error(invalid_argument) naming the `query` if the room cannot be divided evenly.
[[nodiscard]] std::size_t row_length(std::string_view query, std::size_t count, std::size_t room);

/// Throws Error(invalid_argument) naming the `query` unless there is room for one result a query.
void require_room(std::string_view query, std::size_t count, std::size_t room);

/// Counts what it is given and writes it into a row as long as there is room.
template <typename T>
class RowWriter {
public:
    explicit RowWriter(std::span<T> row) noexcept : row_(row) {}

    void operator()(const T& found) noexcept {
        if (count_ < row_.size()) row_[count_] = found;
        ++count_;
    }

    [[nodiscard]] std::uint32_t count() const noexcept { return count_; }

private:
    std::span<T> row_;
    std::uint32_t count_ = 0;
};

}  // namespace coppice
