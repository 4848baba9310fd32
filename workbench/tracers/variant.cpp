#include "tracers/variant.h"

#include "coppice/base/error.h"

#include <fmt/format.h>

#include <charconv>

namespace coppice::lab {

namespace {

/// The percentage in (0, 100] that "10%" writes.
double read_percent(std::string_view name, std::string_view text) {
    double percent = 0.0;
    const char* const digits_end = text.data() + text.size() - (text.ends_with('%') ? 1 : 0);
    const auto [end, error] = std::from_chars(text.data(), digits_end, percent);
    const bool is_read = text.ends_with('%') && error == std::errc{} && end == digits_end;
    if (!is_read || !(percent > 0.0 && percent <= 100.0)) {
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("'{}': expected a percentage in (0, 100] after the @; example: "
                                "fast@10%",
                                name));
    }
    return percent;
}

}  // namespace

std::string variant_name(std::string_view method, double percent) {
    return fmt::format("{}@{}%", method, percent);
}

Variant find_variant(std::string_view name) {
    const std::size_t at = name.find('@');
    const Method& method = find_method(name.substr(0, at));
    Variant variant{method.name, method.options()};
    if (at != std::string_view::npos) {
        sample_of(variant.options).rate = read_percent(name, name.substr(at + 1)) / 100.0;
    }
    return variant;
}

}  // namespace coppice::lab
