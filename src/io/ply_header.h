#pragma once

#include "io/input_file.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::inline v0 {

enum class PlyFormat : std::uint8_t { ascii, binary_little_endian, binary_big_endian };

/// The scalar types of PLY; all their values are exact in a double.
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] std::size_t size_in_bytes(PlyType type) noexcept;

[[nodiscard]] constexpr bool is_integer(PlyType type) noexcept {
    return type != PlyType::float32 && type != PlyType::float64;
}

/// A column of an element: a scalar, or a list with a count in front.
struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    std::optional<PlyType> count_type;  ///< of a list

    [[nodiscard]] bool is_list() const noexcept { return count_type.has_value(); }
};

/// A table of the file: `count` rows of the same properties.
struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
    std::size_t line = 0;  ///< where it is declared

    /// Bytes that a row has at least: in text a digit and a gap for each number.
    [[nodiscard]] std::uint64_t min_row_bytes(PlyFormat format) const noexcept;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;  ///< in the order of the file

    /// Null if the file has no such element.
    [[nodiscard]] const PlyElement* find_element(std::string_view name) const noexcept;
};

/// Reads from the start of the file to the end of the header. Throws Error(parse).
[[nodiscard]] PlyHeader read_ply_header(InputFile& file);

}  // namespace coppice::inline v0
