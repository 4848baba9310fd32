#include "io/ply_header.h"

#include "io/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace coppice::inline v0 {

namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names = {{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

/// Far above the number in any real file. Limits the quadratic time of malicious headers.
constexpr std::size_t max_declarations = 1024;

PlyType parse_type(std::string_view word, const TextPlace& place) {
    for (const auto& [name, type] : type_names) {
        if (name == word) {
            return type;
        }
    }
    place.fail(fmt::format("unknown PLY type {}", in_quotes(word)));
}

PlyFormat parse_format(std::string_view rest, const TextPlace& place) {
    const std::string_view name = take_word(rest);
    const std::string_view version = take_word(rest);
    if (version == "1.0") {
        if (name == "ascii") {
            return PlyFormat::ascii;
        }
        if (name == "binary_little_endian") {
            return PlyFormat::binary_little_endian;
        }
        if (name == "binary_big_endian") {
            return PlyFormat::binary_big_endian;
        }
    }
    place.fail(
        fmt::format("unknown PLY format {}", in_quotes(fmt::format("{} {}", name, version))));
}

PlyElement parse_element(std::string_view rest, const TextPlace& place) {
    PlyElement element;
    element.name = take_word(rest);
    const std::string_view word = take_word(rest);
    const std::optional<std::int64_t> count = parse_integer(word);
    if (element.name.empty() || !count || *count < 0) {
        place.fail(fmt::format("malformed count {} of PLY element {}", in_quotes(word),
                               in_quotes(element.name)));
    }
    element.count = static_cast<std::uint64_t>(*count);
    element.line = place.line;
    return element;
}

PlyProperty parse_property(std::string_view rest, const TextPlace& place) {
    PlyProperty property;
    std::string_view type = take_word(rest);
    if (type == "list") {
        property.count_type = parse_type(take_word(rest), place);
        if (!is_integer(*property.count_type)) {
            place.fail("PLY list with a count that is not an integer");
        }
        type = take_word(rest);
    }
    property.type = parse_type(type, place);
    property.name = take_word(rest);
    if (property.name.empty()) {
        place.fail("PLY property without a name");
    }
    return property;
}

void add_element(PlyHeader& header, PlyElement element, const TextPlace& place) {
    if (header.find_element(element.name) != nullptr) {
        place.fail(fmt::format("PLY element {} declared twice", in_quotes(element.name)));
    }
    if (header.elements.size() == max_declarations) {
        place.fail(fmt::format("more than {} PLY elements", max_declarations));
    }
    header.elements.push_back(std::move(element));
}

void add_property(PlyHeader& header, PlyProperty property, const TextPlace& place) {
    if (header.elements.empty()) {
        place.fail("PLY property before any element");
    }
    std::vector<PlyProperty>& others = header.elements.back().properties;
    const auto is_same = [&](const PlyProperty& other) { return other.name == property.name; };
    if (std::any_of(others.begin(), others.end(), is_same)) {
        place.fail(fmt::format("PLY property {} declared twice", in_quotes(property.name)));
    }
    if (others.size() == max_declarations) {
        place.fail(fmt::format("more than {} properties of a PLY element", max_declarations));
    }
    others.push_back(std::move(property));
}

}  // namespace

std::size_t size_in_bytes(PlyType type) noexcept {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        case PlyType::float64:
            return 8;
    }
    return 0;
}

std::uint64_t PlyElement::min_row_bytes(PlyFormat format) const noexcept {
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : properties) {
        bytes += format == PlyFormat::ascii
                     ? 2
                     : size_in_bytes(property.count_type.value_or(property.type));
    }
    return bytes;
}

const PlyElement* PlyHeader::find_element(std::string_view name) const noexcept {
    const auto found = std::find_if(elements.begin(), elements.end(),
                                    [&](const PlyElement& other) { return other.name == name; });
    return found == elements.end() ? nullptr : &*found;
}

PlyHeader read_ply_header(InputFile& file) {
    PlyHeader header;
    bool has_format = false;
    while (const std::optional<std::string_view> line = file.next_line()) {
        const TextPlace place{file.name(), file.line_number()};
        std::string_view rest = *line;
        const std::string_view keyword = take_word(rest);
        if (place.line == 1) {
            if (keyword != "ply") {
                place.fail("not a PLY file: it does not begin with 'ply'");
            }
        } else if (keyword == "format") {
            header.format = parse_format(rest, place);
            has_format = true;
        } else if (keyword == "element") {
            add_element(header, parse_element(rest, place), place);
        } else if (keyword == "property") {
            add_property(header, parse_property(rest, place), place);
        } else if (keyword == "end_header") {
            if (!has_format) {
                place.fail("PLY header without a format");
            }
            return header;
        } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
            place.fail(fmt::format("unknown word {} in the PLY header", in_quotes(keyword)));
        }
    }
    TextPlace{file.name(), file.line_number()}.fail("PLY header without 'end_header'");
}

}  // namespace coppice::inline v0
