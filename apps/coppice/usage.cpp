#include "usage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>

namespace coppice::app {

namespace {

[[noreturn]] void fail(std::string_view option, std::string_view text, std::string_view what,
                       std::string_view example) {
    throw UsageError(
        fmt::format("{}: '{}' is not {}; example: {} {}", option, text, what, option, example));
}

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// True if all of `text` writes a number, which `value` then is.
template <typename Number>
bool read_number(std::string_view text, Number& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size();
}

bool is_in(const NumberRange& range, double value) {
    const bool is_high_enough = range.is_lowest_in ? value >= range.lowest : value > range.lowest;
    const bool is_low_enough = range.is_highest_in ? value <= range.highest : value < range.highest;
    return is_high_enough && is_low_enough;  // NaN is neither
}

/// Insertions, deletions and replacements between two words (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

double parse_number(std::string_view option, std::string_view text, const NumberRange& range,
                    std::string_view example) {
    double value = 0.0;
    if (!read_number(text, value) || !is_in(range, value)) fail(option, text, range.text, example);
    return value;
}

std::int64_t parse_whole(std::string_view option, std::string_view text, std::int64_t lowest,
                         std::int64_t highest, std::string_view example) {
    std::int64_t value = 0;
    if (!read_number(text, value) || value < lowest || value > highest) {
        fail(option, text, fmt::format("a whole number in [{}, {}]", lowest, highest), example);
    }
    return value;
}

std::vector<std::string> parse_list(std::string_view option, std::span<const std::string> texts,
                                    std::string_view example) {
    std::vector<std::string> items;
    for (const std::string_view text : texts) {
        for (std::size_t first = 0; first <= text.size();) {
            const std::size_t comma = std::min(text.find(',', first), text.size());
            const std::string item(trimmed(text.substr(first, comma - first)));
            if (item.empty()) fail(option, text, "a list with commas between its items", example);
            if (std::find(items.begin(), items.end(), item) == items.end()) items.push_back(item);
            first = comma + 1;
        }
    }
    return items;
}

std::vector<double> parse_percents(std::string_view option, std::span<const std::string> texts) {
    constexpr std::string_view example = "100,50,1";
    constexpr NumberRange range{0.0, 100.0, "a percentage in (0, 100]", false, true};
    std::vector<double> percents;
    for (const std::string& item : parse_list(option, texts, example)) {
        std::string_view digits = item;
        if (digits.ends_with('%')) digits = trimmed(digits.substr(0, digits.size() - 1));
        double percent = 0.0;
        if (!read_number(digits, percent) || !is_in(range, percent)) {
            fail(option, item, range.text, example);
        }
        const bool is_new = std::find(percents.begin(), percents.end(), percent) == percents.end();
        if (is_new) percents.push_back(percent);
    }
    return percents;
}

double parse_share(std::string_view option, std::string_view text) {
    std::string_view digits = trimmed(text);
    const bool is_percent = digits.ends_with('%');
    if (is_percent) digits = trimmed(digits.substr(0, digits.size() - 1));
    double share = 0.0;
    const bool is_number = read_number(digits, share);
    if (is_percent) share /= 100.0;
    if (!is_number || !is_in({0.0, 1.0, "", false, true}, share)) {
        fail(option, text, "a share in (0, 1] or (0%, 100%]", "1%");
    }
    return share;
}

std::uint64_t parse_bytes(std::string_view option, std::string_view text) {
    constexpr std::string_view units = "KMGT";
    constexpr double most = 0x1p62;
    std::string_view digits = trimmed(text);
    const auto drop = [&digits](std::string_view lower, std::string_view upper) {
        const bool is_there = digits.ends_with(lower) || digits.ends_with(upper);
        if (is_there) digits.remove_suffix(lower.size());
        return is_there;
    };
    if (!drop("ib", "iB")) drop("b", "B");
    double unit = 1.0;
    for (std::size_t power = 0; power < units.size(); ++power) {
        const char upper = units[power];
        const auto lower = static_cast<char>(upper - 'A' + 'a');
        if (!drop({&lower, 1}, {&upper, 1})) continue;
        unit = std::exp2(10.0 * static_cast<double>(power + 1));
        break;
    }
    double number = 0.0;
    const bool is_number = read_number(trimmed(digits), number);
    if (!is_number || !(unit * number >= 1.0) || unit * number > most) {
        fail(option, text, "a size of at least 1 byte", "2G");
    }
    return static_cast<std::uint64_t>(unit * number);
}

Vec3f parse_vector(std::string_view option, std::string_view text) {
    Vec3f v;
    std::string_view rest = text;
    for (const Axis axis : all_axes) {
        const std::size_t end = axis == Axis::z ? rest.size() : rest.find(',');
        const bool is_read = end != std::string_view::npos &&
                             read_number(trimmed(rest.substr(0, end)), v[axis]) &&
                             std::isfinite(v[axis]);
        if (!is_read) fail(option, text, "three finite numbers with commas between", "1,2,-3.5");
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return v;
}

PixelSize parse_size(std::string_view option, std::string_view text, int highest) {
    const std::size_t cross = std::min(text.find_first_of("xX"), text.size());
    const auto is_in = [highest](int value) { return value >= 1 && value <= highest; };
    PixelSize size{};
    const bool is_read = cross < text.size() && read_number(text.substr(0, cross), size.width) &&
                         read_number(text.substr(cross + 1), size.height);
    if (!is_read || !is_in(size.width) || !is_in(size.height)) {
        fail(option, text, fmt::format("a width and a height in [1, {}] pixels", highest),
             "1280x720");
    }
    return size;
}

void require_name(std::string_view option, std::string_view name,
                  std::span<const std::string_view> names) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    throw UsageError(fmt::format("{}: unknown name '{}'{}; there are: {}", option, name,
                                 suggestion(name, names), fmt::join(names, ", ")));
}

std::string suggestion(std::string_view given, std::span<const std::string_view> names) {
    std::string name(given);
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    const std::string_view* nearest = nullptr;
    std::size_t nearest_distance = std::max<std::size_t>(2, name.size() / 3) + 1;
    for (const std::string_view& candidate : names) {
        const std::size_t distance = edit_distance(name, candidate);
        if (distance >= nearest_distance || distance >= candidate.size()) continue;
        nearest = &candidate;
        nearest_distance = distance;
    }
    return nearest == nullptr ? std::string() : fmt::format(" (did you mean '{}'?)", *nearest);
}

}  // namespace coppice::app
