#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace coppice::inline v0 {

// Serializes messages between two processes of this program: values one after the other, vectors
// and strings with their length first. A type is written and read by its function
// `exchange(archive, value)`, which calls `archive` with its members.

/// Writes values to bytes.
class MessageWriter {
public:
    template <typename... Values>
    void operator()(const Values&... values) {
        (write(values), ...);
    }

    [[nodiscard]] std::string take() { return std::move(bytes_); }

private:
    template <typename Value>
    void write(const Value& value) {
        if constexpr (std::is_arithmetic_v<Value>) {
            append(&value, sizeof value);
        } else {
            exchange(*this, value);
        }
    }

    void write(const std::string& text) {
        write(std::uint64_t{text.size()});
        append(text.data(), text.size());
    }

    template <typename Item>
    void write(const std::vector<Item>& items) {
        write(std::uint64_t{items.size()});
        if constexpr (std::is_trivially_copyable_v<Item>) {
            append(items.data(), items.size() * sizeof(Item));
        } else {
            for (const Item& item : items) {
                write(item);
            }
        }
    }

    void append(const void* from, std::size_t count) {
        bytes_.append(static_cast<const char*>(from), count);
    }

    std::string bytes_;
};

/// Reads values from bytes. Throws std::out_of_range where the bytes end too early.
class MessageReader {
public:
    explicit MessageReader(std::string_view bytes) noexcept : rest_(bytes) {}

    template <typename... Values>
    void operator()(Values&... values) {
        (read(values), ...);
    }

private:
    template <typename Value>
    void read(Value& value) {
        if constexpr (std::is_arithmetic_v<Value>) {
            copy(&value, sizeof value);
        } else {
            exchange(*this, value);
        }
    }

    void read(std::string& text) {
        text.resize(read_count(1));
        copy(text.data(), text.size());
    }

    template <typename Item>
    void read(std::vector<Item>& items) {
        if constexpr (std::is_trivially_copyable_v<Item>) {
            items.resize(read_count(sizeof(Item)));
            copy(items.data(), items.size() * sizeof(Item));
        } else {
            items.resize(read_count(1));
            for (Item& item : items) {
                read(item);
            }
        }
    }

    /// Reads a number of items of at least `size` bytes each. Throws if the remaining bytes cannot
    /// hold that many.
    [[nodiscard]] std::size_t read_count(std::size_t size) {
        std::uint64_t count = 0;
        read(count);
        if (count > rest_.size() / size) throw std::out_of_range("message");
        return count;
    }

    void copy(void* to, std::size_t count) {
        if (count > rest_.size()) throw std::out_of_range("message");
        if (count > 0) std::memcpy(to, rest_.data(), count);
        rest_.remove_prefix(count);
    }

    std::string_view rest_;
};

}  // namespace coppice::inline v0
