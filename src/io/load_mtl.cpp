// Reads MTL. Not by tinyobjloader, which reads malformed values as 0 and has no line numbers: a
// scene would turn black without a warning.

#include "io/load_mtl.h"

#include "io/input_file.h"
#include "io/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace coppice::inline v0 {

namespace {

/// Parses a finite number >= 0.
std::optional<float> parse_amount(std::string_view word) {
    const std::optional<float> value = parse_float(word);
    const bool is_amount = value && std::isfinite(*value) && *value >= 0.0F;
    return is_amount ? value : std::nullopt;
}

/// Parses `r g b`, or `r` alone for a grey.
std::optional<Vec3f> parse_color(std::string_view rest) {
    std::array<float, 3> channels{};
    std::size_t count = 0;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
        const std::optional<float> value = parse_amount(word);
        if (!value || count == channels.size()) return std::nullopt;
        channels[count++] = *value;
    }
    if (count == 1) return Vec3f{channels[0], channels[0], channels[0]};
    if (count == 3) return Vec3f{channels[0], channels[1], channels[2]};
    return std::nullopt;
}

/// Stores a value if there is one. Returns whether there was.
template <typename To, typename From>
bool take(const std::optional<From>& value, To& to) {
    if (value) to = static_cast<To>(*value);
    return value.has_value();
}

std::optional<int> parse_illumination(std::string_view rest) {
    constexpr std::int64_t highest = 10;
    const std::optional<std::int64_t> value = parse_integer(take_word(rest));
    if (!value || *value < 0 || *value > highest) return std::nullopt;
    return static_cast<int>(*value);
}

/// Reads the values of one statement. Returns false if they are malformed.
bool take_statement(std::string_view keyword, std::string_view rest, Material& material) {
    if (keyword == "Kd") return take(parse_color(rest), material.diffuse);
    if (keyword == "Ks") return take(parse_color(rest), material.specular);
    if (keyword == "Ke") return take(parse_color(rest), material.emission);
    if (keyword == "Ns") return take(parse_amount(take_word(rest)), material.shininess);
    if (keyword == "illum") return take(parse_illumination(rest), material.illumination);
    return true;
}

}  // namespace

std::vector<Material> load_mtl(const std::filesystem::path& file,
                               std::vector<std::string>& warnings) {
    InputFile input(file);
    std::vector<Material> materials;
    std::size_t texture_count = 0;
    while (const std::optional<std::string_view> line = input.next_line()) {
        std::string_view rest = line->substr(0, line->find('#'));
        const std::string_view keyword = take_word(rest);
        if (keyword == "newmtl") {
            materials.emplace_back().name = trimmed(rest);
        } else if (!materials.empty() && !take_statement(keyword, rest, materials.back())) {
            warnings.push_back(fmt::format("{}:{}: malformed {} {}, ignored", input.name(),
                                           input.line_number(), keyword, in_quotes(trimmed(rest))));
        }
        texture_count += keyword.starts_with("map_") ? 1 : 0;
    }
    if (texture_count > 0) {
        warnings.push_back(fmt::format("{}: {} textures are not read; plain colours are used",
                                       input.name(), texture_count));
    }
    return materials;
}

}  // namespace coppice::inline v0
