#pragma once

#include "coppice/geom/vec3.h"
#include "coppice/io/load_mesh.h"

#include "io/input_file.h"
#include "io/obj_attributes.h"
#include "io/text.h"

#include <cstddef>
#include <cstdint>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::inline v0 {

/// The vertex and face statements of an OBJ file, as a stream for tinyobjloader.
///
/// tinyobjloader has no line numbers, reads malformed values as 0 (`nan`, `1x`, the words of a
/// comment after a face) and does not join continued lines. So it receives one whole statement at a
/// time, after the checks here. While it processes a statement, line() is its line. Statements of
/// other kinds are counted in the report and not passed on.
class ObjStatements : public std::streambuf {
public:
    /// Reads from `file` and counts in `report`. `attributes`, if not null, receives the statements
    /// of other kinds first. All must outlive this object.
    ObjStatements(InputFile& file, LoadReport& report, ObjAttributes* attributes)
        : file_(file), report_(report), attributes_(attributes) {}

    /// The coordinates of the current statement, a vertex. tinyobjloader's own are not the nearest
    /// floats: it reads 432.46302795410156251 one unit in the last place too low.
    [[nodiscard]] Vec3f vertex() const noexcept { return vertex_; }

    /// Throws Error(parse) for the first face that refers to a vertex which the whole file does not
    /// define.
    void check_forward_references() const;

protected:
    int_type underflow() override;

private:
    /// A face index beyond the vertices so far, and greater than all earlier ones.
    struct ForwardReference {
        std::size_t line;
        std::int64_t index;
    };

    /// Reads the next vertex or face statement. Returns false if there is none.
    bool next_statement();
    /// Reads a line and its continuation lines, without comments. Returns false at the end of the
    /// file.
    bool next_joined_line();
    [[nodiscard]] Vec3f parse_vertex(std::string_view values) const;
    void check_face(std::string_view corners);
    void check_index(std::int64_t index);

    [[nodiscard]] TextPlace place() const noexcept { return {file_.name(), line_}; }

    InputFile& file_;
    LoadReport& report_;
    ObjAttributes* attributes_;
    std::string text_;      ///< the current statement
    std::size_t line_ = 0;  ///< number of its first line
    Vec3f vertex_;
    std::int64_t vertex_count_ = 0;
    std::vector<ForwardReference> forward_references_;
};

}  // namespace coppice::inline v0
