#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace coppice::inline v0 {

/// A line of a text file, for the errors in it.
struct TextPlace {
    std::string_view file;
    std::size_t line = 0;

    /// Throws Error(parse): `file:line: message`.
    [[noreturn]] void fail(std::string_view message) const;
};

/// Takes the first word, bounded by blanks and tabs, off the front of `rest`; empty if none is
/// left.
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

/// `text` fit for a message of one line: cut short, control characters as `?`.
[[nodiscard]] std::string printable(std::string_view text);

/// printable(text) between single quotes.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// The integer that the whole of `word` spells; nothing if it spells none or one beyond 64 bits.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view word) noexcept;

/// The float nearest to the decimal number that the whole of `word` spells; infinite beyond the
/// range of float, nothing if it spells no number.
[[nodiscard]] std::optional<float> parse_float(std::string_view word) noexcept;

/// The coordinate that `word` spells; fails at `place` unless it is a finite float.
[[nodiscard]] float parse_coordinate(std::string_view word, const TextPlace& place);

}  // namespace coppice::inline v0
