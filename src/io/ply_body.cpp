#include "io/ply_body.h"

#include "coppice/base/error.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

namespace coppice::inline v0 {

void AsciiPlyBody::begin_row(const PlyElement& element, std::uint64_t row) {
    do {
        const std::optional<std::string_view> line = file_.next_line();
        if (!line) {
            fail(fmt::format("file ends after {} of {} rows of element {}", row, element.count,
                             in_quotes(element.name)));
        }
        rest_ = *line;
    } while (is_blank(rest_));
}

void AsciiPlyBody::end_row() {
    const std::string_view word = take_word(rest_);
    if (!word.empty()) {
        fail(fmt::format("unexpected {} at the end of the row", in_quotes(word)));
    }
}

float AsciiPlyBody::next_coordinate(PlyType /*type*/) {
    return parse_coordinate(next_word(), {file_.name(), file_.line_number()});
}

std::int64_t AsciiPlyBody::next_integer(PlyType /*type*/) {
    const std::string_view word = next_word();
    const std::optional<std::int64_t> value = parse_integer(word);
    if (!value) {
        fail(fmt::format("malformed integer {}", in_quotes(word)));
    }
    return *value;
}

float AsciiPlyBody::next_value(PlyType /*type*/) {
    const std::string_view word = next_word();
    const std::optional<float> value = parse_float(word);
    if (!value) {
        fail(fmt::format("malformed number {}", in_quotes(word)));
    }
    return *value;
}

void AsciiPlyBody::skip(PlyType type, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
        static_cast<void>(next_value(type));
    }
}

void AsciiPlyBody::fail(std::string_view message) const {
    TextPlace{file_.name(), file_.line_number()}.fail(message);
}

std::string_view AsciiPlyBody::next_word() {
    const std::string_view word = take_word(rest_);
    if (word.empty()) {
        fail("row with too few numbers");
    }
    return word;
}

float BinaryPlyBody::next_coordinate(PlyType type) {
    const double value = next_number(type);
    if (!(std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max()))) {
        fail(fmt::format("coordinate {} is {}", value,
                         std::isfinite(value) ? "beyond the range of float" : "not finite"));
    }
    return static_cast<float>(value);
}

void BinaryPlyBody::skip(PlyType type, std::uint64_t count) {
    const std::uint64_t bytes = count * size_in_bytes(type);  // count < 2^32
    if (file_.skip(bytes) < bytes) {
        fail_truncated();
    }
}

std::uint64_t BinaryPlyBody::count_trailing_bytes() {
    return file_.skip(std::numeric_limits<std::uint64_t>::max());
}

void BinaryPlyBody::fail(std::string_view message) const {
    throw file_error(ErrorCode::parse, file_.name(),
                     fmt::format("{} {}: {}", printable(element_->name), row_, message));
}

void BinaryPlyBody::fail_truncated() const {
    throw file_error(ErrorCode::parse, file_.name(),
                     fmt::format("file ends at byte {}, after {} of {} rows of element {}",
                                 file_.offset(), row_, element_->count, in_quotes(element_->name)));
}

}  // namespace coppice::inline v0
