// Reads PLY. Not by Assimp, for speed and for errors with their position:
// docs/decisions/0001-own-ply-reader.md. One pass. Memory use grows with the contents of the file,
// not with the counts that its header declares.

#include "io/load_ply.h"

#include "coppice/base/error.h"

#include "io/input_file.h"
#include "io/ply_body.h"
#include "io/ply_header.h"
#include "io/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace coppice::inline v0 {

namespace {

/// The number of rows to reserve memory for: as declared, but at most what the size of the file
/// allows.
std::size_t rows_to_reserve(const PlyElement& element, PlyFormat format, const InputFile& file) {
    const std::uint64_t row_bytes = std::max<std::uint64_t>(element.min_row_bytes(format), 1);
    return static_cast<std::size_t>(std::min(element.count, file.stored_bytes() / row_bytes));
}

/// The scalar property called `name`, or null.
const PlyProperty* find_number(const PlyElement& vertex, std::string_view name) {
    for (const PlyProperty& property : vertex.properties) {
        if (property.name == name && !property.is_list()) {
            return &property;
        }
    }
    return nullptr;
}

const PlyProperty* find_coordinate(const PlyElement& vertex, std::string_view name,
                                   const InputFile& file) {
    const PlyProperty* property = find_number(vertex, name);
    if (property == nullptr) {
        TextPlace{file.name(), vertex.line}.fail(
            fmt::format("PLY element 'vertex' has no property {}", in_quotes(name)));
    }
    return property;
}

const PlyProperty& find_corners(const PlyElement& element, const InputFile& file) {
    for (const PlyProperty& property : element.properties) {
        if ((property.name == "vertex_indices" || property.name == "vertex_index") &&
            property.is_list() && is_integer(property.type)) {
            return property;
        }
    }
    TextPlace{file.name(), element.line}.fail(fmt::format(
        "PLY element {} has no list 'vertex_indices' of integers", in_quotes(element.name)));
}

/// Reads the elements of one file. The body, ASCII or binary, provides the numbers.
template <typename Body>
class PlyReader {
public:
    PlyReader(InputFile& file, const PlyHeader& header, Body body, LoadedMesh& loaded,
              MeshAttributes* attributes)
        : file_(file), header_(header), body_(body), loaded_(loaded), attributes_(attributes) {
        const PlyElement* vertex = header.find_element("vertex");
        vertex_count_ = vertex == nullptr ? 0 : static_cast<std::int64_t>(vertex->count);
    }

    void read() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") {
                read_vertices(element);
            } else if (element.name == "face") {
                read_faces(element);
            } else if (element.name == "tristrips") {
                read_strips(element);
            } else {
                skip_element(element);
            }
        }
        loaded_.report.trailing_byte_count = body_.count_trailing_bytes();
    }

private:
    void read_vertices(const PlyElement& element) {
        const std::array<const PlyProperty*, 3> axes = {find_coordinate(element, "x", file_),
                                                        find_coordinate(element, "y", file_),
                                                        find_coordinate(element, "z", file_)};
        const std::array<const PlyProperty*, 3> normals = normals_wanted(element);
        loaded_.mesh.vertices.reserve(rows_to_reserve(element, header_.format, file_));
        std::array<float, 3> position{};
        std::array<float, 3> normal{};
        for (std::uint64_t row = 0; row < element.count; ++row) {
            body_.begin_row(element, row);
            for (const PlyProperty& property : element.properties) {
                const auto axis = std::find(axes.begin(), axes.end(), &property) - axes.begin();
                if (axis < 3) {
                    position[static_cast<std::size_t>(axis)] = body_.next_coordinate(property.type);
                } else {
                    read_normal(property, normals, normal);
                }
            }
            body_.end_row();
            add_vertex(loaded_, {position[0], position[1], position[2]});
            if (normals[0] != nullptr) {
                attributes_->normals.push_back({normal[0], normal[1], normal[2]});
            }
        }
    }

    /// The properties of the vertices' normals; nulls if normals are not wanted or incomplete.
    std::array<const PlyProperty*, 3> normals_wanted(const PlyElement& vertex) const {
        const std::array<const PlyProperty*, 3> found = {
            find_number(vertex, "nx"), find_number(vertex, "ny"), find_number(vertex, "nz")};
        const bool are_there = std::find(found.begin(), found.end(), nullptr) == found.end();
        if (attributes_ == nullptr || !are_there) {
            return {};
        }
        return found;
    }

    /// Reads a property that is not a coordinate, and keeps it if it is one of `normals`.
    void read_normal(const PlyProperty& property, std::span<const PlyProperty* const, 3> normals,
                     std::array<float, 3>& normal) {
        const auto axis = std::find(normals.begin(), normals.end(), &property) - normals.begin();
        if (axis < 3) {
            normal[static_cast<std::size_t>(axis)] = body_.next_value(property.type);
        } else {
            skip_property(property);
        }
    }

    void read_faces(const PlyElement& element) {
        if (element.count == 0) {
            return;
        }
        loaded_.mesh.triangles.reserve(rows_to_reserve(element, header_.format, file_));
        const PlyProperty& list = find_corners(element, file_);
        std::vector<std::uint32_t> corners;
        for (std::uint64_t row = 0; row < element.count; ++row) {
            corners.clear();
            read_row(element, row, list,
                     [&](std::int64_t index) { corners.push_back(vertex_id(index)); });
            add_face(loaded_, corners);
        }
    }

    /// Reads triangle strips. A strip of n corners is n - 2 triangles with alternating orientation.
    /// A negative index ends a strip and starts the next one.
    void read_strips(const PlyElement& element) {
        if (element.count == 0) {
            return;
        }
        const PlyProperty& list = find_corners(element, file_);
        std::vector<std::uint32_t> strip;
        for (std::uint64_t row = 0; row < element.count; ++row) {
            strip.clear();
            read_row(element, row, list, [&](std::int64_t index) {
                if (index < 0) {
                    add_strip(strip);
                    strip.clear();
                } else {
                    strip.push_back(vertex_id(index));
                }
            });
            add_strip(strip);
        }
    }

    void add_strip(std::span<const std::uint32_t> strip) {
        if (!strip.empty() && strip.size() < 3) {
            add_face(loaded_, strip);
        }
        for (std::size_t i = 2; i < strip.size(); ++i) {
            std::array<std::uint32_t, 3> corners = {strip[i - 2], strip[i - 1], strip[i]};
            if (i % 2 == 1) {
                std::swap(corners[0], corners[1]);
            }
            add_face(loaded_, corners);
        }
    }

    /// Reads a row and passes each number of its list property `list` to `take`.
    template <typename Take>
    void read_row(const PlyElement& element, std::uint64_t row, const PlyProperty& list,
                  const Take& take) {
        body_.begin_row(element, row);
        for (const PlyProperty& property : element.properties) {
            if (&property != &list) {
                skip_property(property);
                continue;
            }
            const std::uint64_t count = next_list_count(property);
            for (std::uint64_t i = 0; i < count; ++i) {
                take(body_.next_integer(property.type));
            }
        }
        body_.end_row();
    }

    void skip_element(const PlyElement& element) {
        loaded_.report.ignored_element_count += element.count;
        if (element.properties.empty()) {
            return;  // rows without bytes, whatever their count
        }
        for (std::uint64_t row = 0; row < element.count; ++row) {
            body_.begin_row(element, row);
            for (const PlyProperty& property : element.properties) {
                skip_property(property);
            }
            body_.end_row();
        }
    }

    void skip_property(const PlyProperty& property) {
        body_.skip(property.type, property.is_list() ? next_list_count(property) : 1);
    }

    std::uint64_t next_list_count(const PlyProperty& list) {
        const std::int64_t count = body_.next_integer(*list.count_type);
        if (count < 0) {
            body_.fail(fmt::format("negative count {} of list {}", count, in_quotes(list.name)));
        }
        return static_cast<std::uint64_t>(count);
    }

    std::uint32_t vertex_id(std::int64_t index) {
        if (index < 0 || index >= vertex_count_) {
            body_.fail(
                fmt::format("vertex index {} out of range ({} vertices)", index, vertex_count_));
        }
        return static_cast<std::uint32_t>(index);
    }

    InputFile& file_;
    const PlyHeader& header_;
    Body body_;
    LoadedMesh& loaded_;
    MeshAttributes* attributes_;
    std::int64_t vertex_count_;
};

}  // namespace

LoadedMesh load_ply(const std::filesystem::path& file, MeshAttributes* attributes) {
    InputFile input(file);
    LoadedMesh loaded;
    loaded.report.file = input.name();
    loaded.report.format = "ply";
    const PlyHeader header = read_ply_header(input);
    if (header.format == PlyFormat::ascii) {
        PlyReader(input, header, AsciiPlyBody(input), loaded, attributes).read();
    } else {
        PlyReader(input, header, BinaryPlyBody(input, header.format), loaded, attributes).read();
    }
    if (loaded.mesh.vertices.empty()) {
        throw file_error(ErrorCode::parse, input.name(), "no vertices");
    }
    if (loaded.report.face_count > 0) {
        check_has_triangles(loaded);
    }
    return loaded;
}

}  // namespace coppice::inline v0
