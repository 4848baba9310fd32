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
/// tinyobjloader knows no line numbers, takes whatever it cannot read for 0 (`nan`, `1x`, the
/// words of a comment behind a face) and does not join continued lines. So it is given one whole
/// statement at a time, and only after the checks here; while it handles one, line() is its line.
/// Statements of other kinds are counted in the report and withheld.
class ObjStatements : public std::streambuf {
public:
    /// All must outlive this. `attributes`, if given, gets the statements of other kinds first.
    ObjStatements(InputFile& file, LoadReport& report, ObjAttributes* attributes)
        : file_(file), report_(report), attributes_(attributes) {}

    /// Coordinates of the current statement, a vertex. tinyobjloader's own are not the nearest
    /// floats: it reads 432.46302795410156251 one unit in the last place too low.
    [[nodiscard]] Vec3f vertex() const noexcept { return vertex_; }

    /// Throws Error(parse) for the first face with a vertex that the whole file does not define.
    void check_forward_references() const;

protected:
    int_type underflow() override;

private:
    /// A face index beyond the vertices so far, and beyond all such before.
    struct ForwardReference {
        std::size_t line;
        std::int64_t index;
    };

    /// Reads to the end of the next vertex or face statement; false if there is none.
    bool next_statement();
    /// Reads a line and those that continue it, without comments; false at the end of the file.
    bool next_joined_line();
    [[nodiscard]] Vec3f parse_vertex(std::string_view values) const;
    void check_face(std::string_view corners);
    void check_index(std::int64_t index);

    [[nodiscard]] TextPlace place() const noexcept { return {file_.name(), line_}; }

    InputFile& file_;
    LoadReport& report_;
    ObjAttributes* attributes_;
    std::string text_;      ///< the current statement
    std::size_t line_ = 0;  ///< its first line
    Vec3f vertex_;
    std::int64_t vertex_count_ = 0;
    std::vector<ForwardReference> forward_references_;
};

}  // namespace coppice::inline v0
