// Reads OBJ. InputFile provides lines, ObjStatements checks them, tinyobjloader parses the faces,
// and this file collects the results.

#include "io/load_obj.h"

#include "io/input_file.h"
#include "io/obj_attributes.h"
#include "io/obj_statements.h"

#include <tiny_obj_loader.h>

#include <istream>
#include <optional>
#include <span>
#include <vector>

namespace coppice::inline v0 {

namespace {

/// The state of the callbacks.
struct ObjReading {
    LoadedMesh loaded;
    const ObjStatements* statements = nullptr;
    ObjAttributes* attributes = nullptr;  ///< null if attributes are not wanted
    std::vector<std::uint32_t> corners;   ///< vertex ids of the current face
    std::vector<std::int64_t> normals;    ///< normal indices of its corners, as in the file
};

void take_vertex(void* user_data, float /*x*/, float /*y*/, float /*z*/, float /*w*/) {
    auto& reading = *static_cast<ObjReading*>(user_data);
    add_vertex(reading.loaded, reading.statements->vertex());
}

void take_face(void* user_data, tinyobj::index_t* indices, int count) {
    auto& reading = *static_cast<ObjReading*>(user_data);
    const auto vertex_count = static_cast<std::int64_t>(reading.loaded.mesh.vertices.size());
    reading.corners.clear();
    reading.normals.clear();
    for (const tinyobj::index_t& corner : std::span(indices, static_cast<std::size_t>(count))) {
        const std::int64_t index = corner.vertex_index;
        reading.corners.push_back(
            static_cast<std::uint32_t>(index > 0 ? index - 1 : vertex_count + index));
        reading.normals.push_back(corner.normal_index);
    }
    add_face(reading.loaded, reading.corners);
    if (reading.attributes != nullptr) reading.attributes->add_face(reading.normals);
}

}  // namespace

LoadedMesh load_obj(const std::filesystem::path& file, MeshAttributes* attributes) {
    InputFile input(file);
    ObjReading reading;
    reading.loaded.report.file = input.name();
    reading.loaded.report.format = "obj";
    std::optional<ObjAttributes> collected;
    if (attributes != nullptr) reading.attributes = &collected.emplace(input.name(), *attributes);
    ObjStatements statements(input, reading.loaded.report, reading.attributes);
    reading.statements = &statements;

    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = take_vertex;
    callbacks.index_cb = take_face;
    std::istream stream(&statements);
    stream.exceptions(std::ios::badbit);  // passes on exceptions of `statements`
    tinyobj::LoadObjWithCallback(stream, callbacks, &reading);

    statements.check_forward_references();
    check_has_triangles(reading.loaded);
    if (collected) collected->finish();
    return std::move(reading.loaded);
}

}  // namespace coppice::inline v0
