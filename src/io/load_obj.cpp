// Reading OBJ: InputFile gives lines, ObjStatements checks them, tinyobjloader takes the faces
// apart, and what is left to do here is to collect the parts.

#include "io/load_obj.h"

#include "io/input_file.h"
#include "io/obj_statements.h"

#include <tiny_obj_loader.h>

#include <istream>
#include <span>
#include <vector>

namespace coppice {

namespace {

/// What the callbacks work on.
struct ObjReading {
    LoadedMesh loaded;
    const ObjStatements* statements = nullptr;
    std::vector<std::uint32_t> corners;  ///< of the current face
};

void take_vertex(void* user_data, float /*x*/, float /*y*/, float /*z*/, float /*w*/) {
    auto& reading = *static_cast<ObjReading*>(user_data);
    add_vertex(reading.loaded, reading.statements->vertex());
}

void take_face(void* user_data, tinyobj::index_t* indices, int count) {
    auto& reading = *static_cast<ObjReading*>(user_data);
    const auto vertex_count = static_cast<std::int64_t>(reading.loaded.mesh.vertices.size());
    reading.corners.clear();
    for (const tinyobj::index_t& corner : std::span(indices, static_cast<std::size_t>(count))) {
        const std::int64_t index = corner.vertex_index;
        reading.corners.push_back(
            static_cast<std::uint32_t>(index > 0 ? index - 1 : vertex_count + index));
    }
    add_face(reading.loaded, reading.corners);
}

}  // namespace

LoadedMesh load_obj(const std::filesystem::path& file) {
    InputFile input(file);
    ObjReading reading;
    reading.loaded.report.file = input.name();
    reading.loaded.report.format = "obj";
    ObjStatements statements(input, reading.loaded.report);
    reading.statements = &statements;

    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = take_vertex;
    callbacks.index_cb = take_face;
    std::istream stream(&statements);
    stream.exceptions(std::ios::badbit);  // lets the errors of `statements` through
    tinyobj::LoadObjWithCallback(stream, callbacks, &reading);

    statements.check_forward_references();
    check_has_triangles(reading.loaded);
    return std::move(reading.loaded);
}

}  // namespace coppice
