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

/// A property of an element: a scalar, or a list preceded by its count.
struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    std::optional<PlyType> count_type;  ///< type of the count of a list; none for a scalar

    [[nodiscard]] bool is_list() const noexcept { return count_type.has_value(); }
};

/// An element: a table of `count` rows with the same properties.
struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
    std::size_t line = 0;  ///< line of its declaration

    /// The least number of bytes of a row. In text, a digit and a separator for each number.
    [[nodiscard]] std::uint64_t min_row_bytes(PlyFormat format) const noexcept;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;  ///< in the order of the file

    /// The element called `name`, or null.
    [[nodiscard]] const PlyElement* find_element(std::string_view name) const noexcept;
};

/// Reads the header, from the start of the file. Throws Error(parse) if it is malformed.
[[nodiscard]] PlyHeader read_ply_header(InputFile& file);

}  // namespace coppice::inline v0
