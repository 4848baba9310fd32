// Reads OFF. Not by Assimp 5.2.5, which drops faces of more than nine corners, reads malformed and
// negative indices as 0, and crashes on some damaged files: docs/decisions/0001-own-ply-reader.md.

#include "io/load_off.h"

#include "io/input_file.h"
#include "io/text.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace coppice::inline v0 {

namespace {

/// The rows of an OFF file: its lines without comments and empty lines.
class OffRows {
public:
    /// Reads from `file`, which must outlive this object.
    explicit OffRows(InputFile& file) : file_(file) {}

    /// The next row. Valid until the next call. Throws Error(parse) at the end of the file.
    [[nodiscard]] std::string_view next() {
        while (const std::optional<std::string_view> line = file_.next_line()) {
            const std::string_view row = line->substr(0, line->find('#'));
            if (!is_blank(row)) {
                return row;
            }
        }
        fail("file ends before all vertices and faces that its header declares");
    }

    /// Throws Error(parse) naming the line of the current row.
    [[noreturn]] void fail(std::string_view message) const { place().fail(message); }

    [[nodiscard]] TextPlace place() const noexcept { return {file_.name(), file_.line_number()}; }

private:
    InputFile& file_;
};

/// Reads the numbers of vertices, faces and edges, which follow the keyword on one or more lines.
std::array<std::int64_t, 3> read_counts(OffRows& rows) {
    std::string_view rest = rows.next();
    const std::string_view keyword = take_word(rest);
    if (!keyword.ends_with("OFF")) {
        rows.fail("not an OFF file: it does not begin with 'OFF'");
    }
    if (keyword.find_first_of("4n") != std::string_view::npos) {
        rows.fail(fmt::format("{} is not supported: only three-dimensional OFF files are",
                              in_quotes(keyword)));
    }
    std::array<std::int64_t, 3> counts{};
    for (std::int64_t& count : counts) {
        while (is_blank(rest)) {
            rest = rows.next();
        }
        const std::string_view word = take_word(rest);
        const std::optional<std::int64_t> value = parse_integer(word);
        if (!value || *value < 0) {
            rows.fail(fmt::format("malformed count {}", in_quotes(word)));
        }
        count = *value;
    }
    return counts;
}

Vec3f parse_vertex(std::string_view row, const TextPlace& place) {
    std::array<float, 3> position{};
    for (float& coordinate : position) {
        const std::string_view word = take_word(row);
        if (word.empty()) {
            place.fail("vertex with fewer than three numbers");
        }
        coordinate = parse_coordinate(word, place);
    }
    return {position[0], position[1], position[2]};
}

/// Reads the corners of a face. Ignores a colour after them.
void parse_face(std::string_view row, const OffRows& rows, std::size_t vertex_count,
                std::vector<std::uint32_t>& corners) {
    const std::string_view count_word = take_word(row);
    const std::optional<std::int64_t> corner_count = parse_integer(count_word);
    if (!corner_count || *corner_count < 0) {
        rows.fail(fmt::format("malformed corner count {}", in_quotes(count_word)));
    }
    corners.clear();
    for (std::int64_t i = 0; i < *corner_count; ++i) {
        const std::string_view word = take_word(row);
        const std::optional<std::int64_t> index = parse_integer(word);
        if (!index) {
            rows.fail(word.empty() ? fmt::format("face with fewer than {} indices", *corner_count)
                                   : fmt::format("malformed vertex index {}", in_quotes(word)));
        }
        if (*index < 0 || static_cast<std::uint64_t>(*index) >= vertex_count) {
            rows.fail(
                fmt::format("vertex index {} out of range ({} vertices)", *index, vertex_count));
        }
        corners.push_back(static_cast<std::uint32_t>(*index));
    }
}

}  // namespace

LoadedMesh load_off(const std::filesystem::path& file) {
    InputFile input(file);
    LoadedMesh loaded;
    loaded.report.file = input.name();
    loaded.report.format = "off";
    OffRows rows(input);
    const auto [vertex_count, face_count, edge_count] = read_counts(rows);
    for (std::int64_t i = 0; i < vertex_count; ++i) {
        const std::string_view row = rows.next();
        add_vertex(loaded, parse_vertex(row, rows.place()));
    }
    std::vector<std::uint32_t> corners;
    for (std::int64_t i = 0; i < face_count; ++i) {
        const std::string_view row = rows.next();
        parse_face(row, rows, loaded.mesh.vertices.size(), corners);
        add_face(loaded, corners);
    }
    loaded.report.trailing_byte_count = input.count_trailing_text();
    check_has_triangles(loaded);
    return loaded;
}

}  // namespace coppice::inline v0
