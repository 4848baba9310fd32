#include "io/text.h"

#include "coppice/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace coppice::inline v0 {

namespace {

bool is_digit(char c) noexcept {
    return c >= '0' && c <= '9';
}

}  // namespace

void TextPlace::fail(std::string_view message) const {
    throw file_error(ErrorCode::parse, file, line, message);
}

std::string_view trimmed(std::string_view text) noexcept {
    constexpr std::string_view gaps = " \t";
    const std::size_t first = text.find_first_not_of(gaps);
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(gaps) - first + 1);
}

bool is_blank(std::string_view text) noexcept {
    return text.find_first_not_of(" \t\r\n\v\f") == std::string_view::npos;
}

std::string to_lower(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

std::string printable(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string shown(text.substr(0, longest));
    std::replace_if(
        shown.begin(), shown.end(), [](unsigned char c) { return c < ' ' || c == 127; }, '?');
    return shown + (text.size() > longest ? "..." : "");
}

std::string in_quotes(std::string_view text) {
    return fmt::format("'{}'", printable(text));
}

std::optional<std::int64_t> parse_integer(std::string_view word) noexcept {
    std::int64_t value = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, problem] = std::from_chars(word.data(), end, value);
    if (problem != std::errc() || stop != end) {
        return std::nullopt;
    }
    return value;
}

std::optional<float> parse_float(std::string_view word) noexcept {
    if (word.starts_with('+') && !word.starts_with("+-")) {
        word.remove_prefix(1);  // from_chars() does not accept a plus sign
    }
    float value = 0.0F;
    const char* const end = word.data() + word.size();
    const auto [stop, problem] = std::from_chars(word.data(), end, value);
    if (stop != end || problem == std::errc::invalid_argument) {
        return std::nullopt;
    }
    if (problem == std::errc::result_out_of_range) {
        // Distinguishes overflow from underflow of float: a long double has a much greater range.
        long double wide = std::numeric_limits<long double>::infinity();
        std::from_chars(word.data(), end, wide);
        value =
            std::fabs(wide) < 1 ? static_cast<float>(wide) : std::numeric_limits<float>::infinity();
    }
    return value;
}

float parse_coordinate(std::string_view word, const TextPlace& place) {
    const std::optional<float> value = parse_float(word);
    if (!value) {
        place.fail(fmt::format("malformed coordinate {}", in_quotes(word)));
    }
    if (!std::isfinite(*value)) {
        const bool is_number =
            !std::isnan(*value) && std::any_of(word.begin(), word.end(), is_digit);
        place.fail(fmt::format("coordinate {} is {}", in_quotes(word),
                               is_number ? "beyond the range of float" : "not finite"));
    }
    return *value;
}

}  // namespace coppice::inline v0
