#include "io/import_answer.h"

#include "io/message.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <span>

namespace coppice::inline v0 {

// Overloads of exchange() for the types in an answer, found by argument-dependent lookup. Each one
// both reads and writes; `value` is const when it is written.

template <typename Archive, typename Value>
requires std::same_as<std::remove_const_t<Value>, LoadIssue>

void exchange(Archive& archive, Value& value) {
    archive(value.count, value.first);
}

template <typename Archive, typename Value>
requires std::same_as<std::remove_const_t<Value>, Material>

void exchange(Archive& archive, Value& value) {
    archive(value.name, value.diffuse.x, value.diffuse.y, value.diffuse.z, value.specular.x,
            value.specular.y, value.specular.z, value.emission.x, value.emission.y,
            value.emission.z, value.shininess, value.illumination);
}

/// The data that an importer provides.
template <typename Archive, typename Value>
requires std::same_as<std::remove_const_t<Value>, LoadReport>

void exchange(Archive& archive, Value& value) {
    archive(value.file, value.format, value.face_count, value.polygons, value.degenerate_faces,
            value.warning_count, value.warnings);
}

template <typename Archive, typename Value>
requires std::same_as<std::remove_const_t<Value>, ImportAnswer>

void exchange(Archive& archive, Value& value) {
    archive(value.error, value.error_code, value.loaded.mesh.vertices, value.loaded.mesh.triangles,
            value.loaded.report, value.attributes.materials, value.attributes.triangle_materials,
            value.attributes.normals, value.attributes.triangle_normals, value.attributes.warnings);
}

namespace {

bool are_below(std::span<const TriangleIndices> triangles, std::size_t count) {
    return std::all_of(triangles.begin(), triangles.end(), [&](const TriangleIndices& corners) {
        return std::all_of(corners.begin(), corners.end(),
                           [&](std::uint32_t corner) { return corner < count; });
    });
}

bool are_finite(std::span<const Vec3f> points) {
    return std::all_of(points.begin(), points.end(), is_finite);
}

/// True if an answer contains only what an importer can produce.
bool is_sound(const ImportAnswer& answer) {
    const TriangleMesh& mesh = answer.loaded.mesh;
    const MeshAttributes& attributes = answer.attributes;
    const auto& materials = attributes.triangle_materials;
    const auto& normals = attributes.normals;
    return are_below(mesh.triangles, mesh.vertices.size()) && are_finite(mesh.vertices) &&
           (materials.empty() || materials.size() == mesh.triangles.size()) &&
           std::all_of(materials.begin(), materials.end(),
                       [&](std::uint32_t material) {
                           return material < attributes.materials.size() ||
                                  material == MeshAttributes::none;
                       }) &&
           (normals.empty() || normals.size() == mesh.vertices.size()) &&
           attributes.triangle_normals.empty();
}

}  // namespace

std::string to_bytes(const ImportAnswer& answer) {
    MessageWriter writer;
    exchange(writer, answer);
    return writer.take();
}

ImportAnswer import_answer_from(std::string_view bytes, std::string_view file) {
    ImportAnswer answer;
    bool is_whole = true;
    try {
        MessageReader reader(bytes);
        exchange(reader, answer);
    } catch (const std::out_of_range&) {
        is_whole = false;
    }
    if (is_whole && !answer.error.empty()) {
        throw Error(static_cast<ErrorCode>(answer.error_code), answer.error);
    }
    if (!is_whole || !is_sound(answer)) {
        throw file_error(ErrorCode::parse, file,
                         "Assimp returned invalid data: the file is damaged");
    }
    return answer;
}

}  // namespace coppice::inline v0
