#include "report/format.h"

#include "text/json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace coppice::report {
namespace {

constexpr const char* not_a_number = "–";

std::string replace_all(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
    return text;
}

std::string with_separators(std::string digits) {
    const std::size_t start = digits.starts_with('-') ? 1 : 0;
    std::size_t end = std::min(digits.find('.'), digits.size());
    while (end > start + 3) {
        end -= 3;
        digits.insert(end, 1, ',');
    }
    return digits;
}

// Three significant digits, but never fewer than the integer has.
std::string three_digits(double value) {
    if (!std::isfinite(value)) return not_a_number;
    if (value == 0.0) return "0";
    const double magnitude = std::floor(std::log10(std::abs(value)));
    const int decimals = std::clamp(2 - static_cast<int>(magnitude), 0, 9);
    return with_separators(fmt::format("{:.{}f}", value, decimals));
}

}  // namespace

std::string escape_html(std::string_view text) {
    std::string escaped;
    escaped.reserve(text.size());
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

std::string script_json(const nlohmann::json& json) {
    return replace_all(lab::json_line(json), "<", "\\u003c");
}

std::string script_text(std::string_view javascript) {
    // `<\/script` means the same to JavaScript, in strings and in regular expressions.
    std::string text(javascript);
    constexpr std::string_view end_tag = "</script";
    const auto same_letter = [](char a, char b) { return std::tolower(a) == b; };
    for (auto at = text.begin();;) {
        at = std::search(at, text.end(), end_tag.begin(), end_tag.end(), same_letter);
        if (at == text.end()) break;
        at = text.insert(at + 1, '\\');
    }
    if (const std::size_t map = text.rfind("//# sourceMappingURL="); map != std::string::npos) {
        const std::size_t line_end = text.find('\n', map);
        text.erase(map, line_end == std::string::npos ? line_end : line_end - map);
    }
    return text;
}

std::string make_slug(std::string_view text) {
    std::string slug;
    for (const char c : text) {
        const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        if (is_letter || (c >= '0' && c <= '9')) {
            slug += static_cast<char>(std::tolower(c));
        } else if (!slug.empty() && slug.back() != '-') {
            slug += '-';
        }
    }
    while (slug.ends_with('-')) {
        slug.pop_back();
    }
    return slug.empty() ? "unnamed" : slug;
}

std::string capitalize(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') {
        text[0] = static_cast<char>(std::toupper(text[0]));
    }
    return text;
}

std::string format_count(double count) {
    if (!std::isfinite(count)) return not_a_number;
    if (count != std::floor(count)) return three_digits(count);
    return with_separators(fmt::format("{:.0f}", count));
}

std::string format_percent(double percent) {
    return fmt::format("{:.6g}\u00a0%", percent);
}

std::string format_ratio(double ratio) {
    return three_digits(ratio);
}

std::string format_share(double share) {
    return three_digits(100.0 * share) + "\u00a0%";
}

std::string format_duration(double seconds) {
    if (seconds == 0.0) return "0 s";
    const double size = std::abs(seconds);
    if (size < 1e-3) return three_digits(seconds * 1e6) + " µs";
    if (size < 1.0) return three_digits(seconds * 1e3) + " ms";
    return three_digits(seconds) + " s";
}

std::string format_milliseconds(double seconds) {
    const double milliseconds = seconds * 1e3;
    if (!std::isfinite(milliseconds)) return not_a_number;
    if (milliseconds == 0.0) return "0";
    if (std::abs(milliseconds) < 5e-4) return "<0.001";
    const double size = std::abs(milliseconds);
    const int decimals = size >= 100.0 ? 0 : size >= 10.0 ? 1 : size >= 1.0 ? 2 : 3;
    return with_separators(fmt::format("{:.{}f}", milliseconds, decimals));
}

std::string format_bytes(double bytes) {
    constexpr std::array units{"B", "KiB", "MiB", "GiB", "TiB"};
    std::size_t unit = 0;
    while (std::abs(bytes) >= 1024.0 && unit + 1 < units.size()) {
        bytes /= 1024.0;
        ++unit;
    }
    return fmt::format("{} {}", unit == 0 ? format_count(bytes) : three_digits(bytes), units[unit]);
}

}  // namespace coppice::report
