#pragma once

#include "io/input_file.h"
#include "io/ply_header.h"
#include "io/text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace coppice::inline v0 {

/// Reads the numbers of an ASCII PLY file in order. A row is a line. Has the same members as
/// BinaryPlyBody. Throws Error(parse) naming the line.
class AsciiPlyBody {
public:
    /// `file` has just given the end of its header, and outlives this.
    explicit AsciiPlyBody(InputFile& file) : file_(file) {}

    void begin_row(const PlyElement& element, std::uint64_t row);
    /// Ends a row. Throws Error(parse) if it has numbers left.
    void end_row();

    /// Reads a finite float. Throws Error(parse) for any other number.
    [[nodiscard]] float next_coordinate(PlyType type);
    /// Reads any number as a float.
    [[nodiscard]] float next_value(PlyType type);
    [[nodiscard]] std::int64_t next_integer(PlyType type);
    /// Skips `count` numbers.
    void skip(PlyType type, std::uint64_t count);

    /// The number of bytes after the last row, without white space.
    [[nodiscard]] std::uint64_t count_trailing_bytes() { return file_.count_trailing_text(); }

    [[noreturn]] void fail(std::string_view message) const;

private:
    [[nodiscard]] std::string_view next_word();

    InputFile& file_;
    std::string_view rest_;  ///< unread part of the current row
};

/// Reads the numbers of a binary PLY file in order. Throws Error(parse) naming the element and row.
class BinaryPlyBody {
public:
    /// `file` has just given the end of its header, and outlives this.
    BinaryPlyBody(InputFile& file, PlyFormat format)
        : file_(file),
          is_swapped_((format == PlyFormat::binary_little_endian) !=
                      (std::endian::native == std::endian::little)) {}

    void begin_row(const PlyElement& element, std::uint64_t row) noexcept {
        element_ = &element;
        row_ = row;
    }

    void end_row() noexcept {}

    [[nodiscard]] float next_coordinate(PlyType type);

    [[nodiscard]] float next_value(PlyType type) { return static_cast<float>(next_number(type)); }

    [[nodiscard]] std::int64_t next_integer(PlyType type) {
        return static_cast<std::int64_t>(next_number(type));
    }

    void skip(PlyType type, std::uint64_t count);
    [[nodiscard]] std::uint64_t count_trailing_bytes();
    [[noreturn]] void fail(std::string_view message) const;

private:
    [[noreturn]] void fail_truncated() const;

    /// Reads any PLY scalar, all of which are exact in a double.
    [[nodiscard]] double next_number(PlyType type) {
        switch (type) {
            case PlyType::int8:
                return next<std::int8_t>();
            case PlyType::uint8:
                return next<std::uint8_t>();
            case PlyType::int16:
                return next<std::int16_t>();
            case PlyType::uint16:
                return next<std::uint16_t>();
            case PlyType::int32:
                return next<std::int32_t>();
            case PlyType::uint32:
                return next<std::uint32_t>();
            case PlyType::float32:
                return next<float>();
            case PlyType::float64:
                return next<double>();
        }
        return 0.0;
    }

    template <typename T>
    [[nodiscard]] T next() {
        const std::string_view read = file_.read(sizeof(T));
        if (read.size() < sizeof(T)) {
            fail_truncated();
        }
        std::array<char, sizeof(T)> bytes;
        std::copy_n(read.data(), sizeof(T), bytes.begin());
        if (is_swapped_) {
            std::reverse(bytes.begin(), bytes.end());
        }
        return std::bit_cast<T>(bytes);
    }

    InputFile& file_;
    bool is_swapped_;
    const PlyElement* element_ = nullptr;  ///< element of the current row
    std::uint64_t row_ = 0;
};

}  // namespace coppice::inline v0
