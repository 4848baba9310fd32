#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace coppice::inline v0 {

/// A line of a text file, for error messages.
struct TextPlace {
    std::string_view file;
    std::size_t line = 0;

    /// Throws Error(parse): `file:line: message`.
    [[noreturn]] void fail(std::string_view message) const;
};

/// Removes the first word, which ends at a blank or tab, from the front of `rest` and returns it;
/// empty if there is none.
[[nodiscard]] inline std::string_view take_word(std::string_view& rest) noexcept {
    const auto is_gap = [](char c) { return c == ' ' || c == '\t'; };
    std::size_t begin = 0;
    while (begin < rest.size() && is_gap(rest[begin])) {
        ++begin;
    }
    std::size_t end = begin;
    while (end < rest.size() && !is_gap(rest[end])) {
        ++end;
    }
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

/// `text` without the blanks and tabs around it.
[[nodiscard]] std::string_view trimmed(std::string_view text) noexcept;

/// True if there is nothing but white space in `text`.
[[nodiscard]] bool is_blank(std::string_view text) noexcept;

[[nodiscard]] std::string to_lower(std::string_view text);

/// `text` in a form fit for a one-line message: shortened, with control characters replaced by `?`.
[[nodiscard]] std::string printable(std::string_view text);

/// printable(text) between single quotes.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// Parses all of `word` as an integer. Returns nothing if it is none, or does not fit in 64 bits.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view word) noexcept;

/// Parses all of `word` as a decimal number and returns the nearest float; infinite beyond the
/// range of float. Returns nothing if it is no number.
[[nodiscard]] std::optional<float> parse_float(std::string_view word) noexcept;

/// Parses `word` as a coordinate. Throws Error(parse) at `place` unless it is a finite float.
[[nodiscard]] float parse_coordinate(std::string_view word, const TextPlace& place);

}  // namespace coppice::inline v0
