#include "io/obj_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <system_error>

namespace coppice::inline v0 {

namespace {

/// The vertex index of a face corner, which must have the form v, v/vt, v//vn or v/vt/vn with
/// integers; nothing if it does not. vt and vn are not checked against the file here.
std::optional<std::int64_t> vertex_index(std::string_view corner) {
    const char* const end = corner.data() + corner.size();
    std::array<std::int64_t, 3> indices{};
    const char* at = corner.data();
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const auto [stop, problem] = std::from_chars(at, end, indices[i]);
        const bool is_gap = i == 1 && stop == at && stop != end && *stop == '/';
        if (problem != std::errc() && !is_gap) {
            return std::nullopt;
        }
        if (stop == end) {
            return indices[0];
        }
        if (*stop != '/') {
            return std::nullopt;
        }
        at = stop + 1;
    }
    return std::nullopt;
}

std::string_view without_comment(std::string_view line) {
    return line.substr(0, line.find('#'));
}

}  // namespace

ObjStatements::int_type ObjStatements::underflow() {
    if (!next_statement()) {
        return traits_type::eof();
    }
    setg(text_.data(), text_.data(), text_.data() + text_.size());
    return traits_type::to_int_type(text_.front());
}

bool ObjStatements::next_statement() {
    while (next_joined_line()) {
        std::string_view rest = text_;
        const std::string_view keyword = take_word(rest);
        if (keyword == "v") {
            vertex_ = parse_vertex(rest);
            ++vertex_count_;
            text_ = "v \n";  // enough for tinyobjloader to report a vertex
            return true;
        }
        if (keyword == "f") {
            check_face(rest);
            text_ += '\n';
            return true;
        }
        if (attributes_ != nullptr && attributes_->take_statement(keyword, rest)) {
            continue;
        }
        report_.ignored_line_count += keyword.empty() ? 0 : 1;
    }
    return false;
}

bool ObjStatements::next_joined_line() {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    std::optional<std::string_view> line = file_.next_line();
    if (!line) {
        return false;
    }
    line_ = file_.line_number();
    if (line_ == 1 && line->starts_with(byte_order_mark)) {
        line->remove_prefix(byte_order_mark.size());
    }
    text_.assign(without_comment(*line));
    while (text_.ends_with('\\')) {
        text_.back() = ' ';
        if ((line = file_.next_line())) {
            text_ += without_comment(*line);
        }
    }
    return true;
}

Vec3f ObjStatements::parse_vertex(std::string_view values) const {
    std::array<float, 3> position{};
    std::size_t count = 0;
    for (std::string_view word = take_word(values); !word.empty(); word = take_word(values)) {
        if (count < position.size()) {
            position[count] = parse_coordinate(word, place());
        } else if (!parse_float(word)) {
            place().fail(fmt::format("malformed number {} after a vertex", in_quotes(word)));
        }
        ++count;
    }
    // x y z, optionally with a weight, a colour, or both.
    constexpr std::array<std::size_t, 4> known_counts = {3, 4, 6, 7};
    if (std::find(known_counts.begin(), known_counts.end(), count) == known_counts.end()) {
        place().fail(fmt::format("vertex of {} numbers (3, 4, 6 or 7 expected)", count));
    }
    return {position[0], position[1], position[2]};
}

void ObjStatements::check_face(std::string_view corners) {
    std::string_view corner = take_word(corners);
    if (corner.empty()) {
        place().fail("face without indices");
    }
    for (; !corner.empty(); corner = take_word(corners)) {
        const std::optional<std::int64_t> index = vertex_index(corner);
        if (!index) {
            place().fail(fmt::format("malformed face index {}", in_quotes(corner)));
        }
        check_index(*index);
    }
}

void ObjStatements::check_index(std::int64_t index) {
    if (index == 0) {
        place().fail("face index 0 (OBJ indices start at 1)");
    }
    if (index < -vertex_count_) {
        place().fail(
            fmt::format("face index {} out of range ({} vertices so far)", index, vertex_count_));
    }
    if (index < 0) {
        ++report_.negative_index_count;
    }
    // If any index exceeds the final number of vertices, the first such index is greater than all
    // before it, so it is sufficient to keep those maxima.
    if (index > vertex_count_ &&
        (forward_references_.empty() || index > forward_references_.back().index)) {
        forward_references_.push_back({line_, index});
    }
}

void ObjStatements::check_forward_references() const {
    constexpr std::int64_t tinyobj_limit = std::numeric_limits<int>::max();
    for (const ForwardReference& reference : forward_references_) {
        if (reference.index > std::min(vertex_count_, tinyobj_limit)) {
            TextPlace{file_.name(), reference.line}.fail(fmt::format(
                "face index {} out of range ({} vertices)", reference.index, vertex_count_));
        }
    }
}

}  // namespace coppice::inline v0
