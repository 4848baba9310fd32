// Reads files through Assimp, in a separate process (docs/decisions/0007): on damaged files Assimp
// crashes or writes out of bounds. The answer of that process is validated like untrusted input.

#include "io/load_scene_file.h"

#include "coppice/base/error.h"
#include "coppice/io/load_mesh.h"

#include "io/assimp_log.h"
#include "io/import_answer.h"
#include "io/input_file.h"
#include "io/isolate.h"
#include "io/text.h"

#include <assimp/Importer.hpp>
#include <assimp/commonMetaData.h>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace coppice::inline v0 {

namespace {

[[noreturn]] void fail_in_mesh(const LoadedMesh& loaded, const aiMesh& mesh,
                               const std::string& message) {
    throw file_error(ErrorCode::parse, loaded.report.file,
                     fmt::format("mesh {}: {}", in_quotes(mesh.mName.C_Str()), message));
}

void append_vertices(LoadedMesh& loaded, const aiMesh& mesh, const aiMatrix4x4& to_world) {
    for (unsigned id = 0; id < mesh.mNumVertices; ++id) {
        const aiVector3D moved = to_world * mesh.mVertices[id];
        const Vec3f position{moved.x, moved.y, moved.z};
        if (!is_finite(position)) {
            fail_in_mesh(loaded, mesh,
                         fmt::format("vertex {}: position ({}, {}, {}) is not finite", id,
                                     position.x, position.y, position.z));
        }
        add_vertex(loaded, position);
    }
}

/// Appends the normals of a mesh; zeros if it has none.
void append_normals(MeshAttributes& attributes, const aiMesh& mesh, const aiMatrix4x4& to_world) {
    // Normals are transformed by the inverse transpose. A matrix without an inverse flattens the
    // mesh.
    const aiMatrix3x3 linear(to_world);
    const bool can_invert = linear.Determinant() != 0.0F;
    const aiMatrix3x3 turn =
        can_invert ? aiMatrix3x3(linear).Inverse().Transpose() : aiMatrix3x3(linear);
    for (unsigned id = 0; id < mesh.mNumVertices; ++id) {
        aiVector3D normal;
        if (mesh.HasNormals() && can_invert) normal = turn * mesh.mNormals[id];
        attributes.normals.push_back({normal.x, normal.y, normal.z});
    }
}

/// A colour by its key; `AI_MATKEY_...` expands to all three parts of a key.
Vec3f color_of(const aiMaterial& material, const char* key, unsigned type, unsigned index,
               Vec3f otherwise) {
    aiColor3D color(otherwise.x, otherwise.y, otherwise.z);
    static_cast<void>(material.Get(key, type, index, color));
    const auto amount = [](float value) { return value >= 0.0F ? std::min(value, 1e30F) : 0.0F; };
    return {amount(color.r), amount(color.g), amount(color.b)};
}

/// Converts a material to the terms of MTL, with highlights where the file has them, and without
/// mirrors.
Material to_material(const aiMaterial& from) {
    Material material;
    material.name = from.GetName().C_Str();
    material.diffuse = color_of(from, AI_MATKEY_COLOR_DIFFUSE, material.diffuse);
    material.emission = color_of(from, AI_MATKEY_COLOR_EMISSIVE, material.emission);
    int shading = aiShadingMode_Gouraud;
    static_cast<void>(from.Get(AI_MATKEY_SHADING_MODEL, shading));
    if (shading == aiShadingMode_Phong || shading == aiShadingMode_Blinn) {
        material.illumination = 2;
        material.specular = color_of(from, AI_MATKEY_COLOR_SPECULAR, material.specular);
        static_cast<void>(from.Get(AI_MATKEY_SHININESS, material.shininess));
        const bool is_amount = material.shininess >= 0.0F && std::isfinite(material.shininess);
        if (!is_amount) material.shininess = 0.0F;
    }
    return material;
}

void append_attributes(MeshAttributes& attributes, const LoadedMesh& loaded, const aiMesh& mesh,
                       const aiMatrix4x4& to_world) {
    append_normals(attributes, mesh, to_world);
    attributes.triangle_materials.resize(loaded.mesh.triangles.size(),
                                         mesh.mMaterialIndex < attributes.materials.size()
                                             ? mesh.mMaterialIndex
                                             : MeshAttributes::none);
}

void append_mesh(LoadedMesh& loaded, const aiMesh& mesh, const aiMatrix4x4& to_world) {
    const auto first_vertex = static_cast<std::uint32_t>(loaded.mesh.vertices.size());
    append_vertices(loaded, mesh, to_world);
    std::vector<std::uint32_t> corners;
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
        corners.clear();
        for (const unsigned index : std::span(face.mIndices, face.mNumIndices)) {
            if (index >= mesh.mNumVertices) {
                fail_in_mesh(loaded, mesh,
                             fmt::format("vertex index {} out of range ({} vertices)", index,
                                         mesh.mNumVertices));
            }
            corners.push_back(first_vertex + index);
        }
        add_face(loaded, corners);
    }
}

/// Appends the meshes of all nodes. A mesh that several nodes refer to is appended several times.
void append_scene(LoadedMesh& loaded, const aiScene& scene, MeshAttributes* attributes) {
    if (attributes != nullptr) {
        for (const aiMaterial* material : std::span(scene.mMaterials, scene.mNumMaterials)) {
            attributes->materials.push_back(to_material(*material));
        }
    }
    std::vector<std::pair<const aiNode*, aiMatrix4x4>> open = {{scene.mRootNode, aiMatrix4x4()}};
    while (!open.empty()) {
        const auto [node, parent_to_world] = open.back();
        open.pop_back();
        const aiMatrix4x4 to_world = parent_to_world * node->mTransformation;
        for (const unsigned mesh : std::span(node->mMeshes, node->mNumMeshes)) {
            append_mesh(loaded, *scene.mMeshes[mesh], to_world);
            if (attributes != nullptr) {
                append_attributes(*attributes, loaded, *scene.mMeshes[mesh], to_world);
            }
        }
        // Pushed in reverse order, so that meshes come in the order of the file.
        for (unsigned child = node->mNumChildren; child > 0; --child) {
            open.emplace_back(node->mChildren[child - 1], to_world);
        }
    }
}

std::string format_name(const aiScene& scene) {
    aiString name;
    if (scene.mMetaData != nullptr) {
        scene.mMetaData->Get(AI_METADATA_SOURCE_FORMAT, name);
    }
    return name.C_Str();
}

/// Called in the separate process.
void import_scene(const std::filesystem::path& file, AssimpLog& log, ImportAnswer& answer,
                  bool with_attributes) {
    LoadedMesh& loaded = answer.loaded;
    Assimp::Importer importer;
    // No post-processing: vertices keep their order, and polygons are triangulated as in other
    // formats.
    const aiScene* const scene = importer.ReadFile(file.string(), 0);
    if (scene == nullptr || scene->mRootNode == nullptr) {
        throw file_error(ErrorCode::parse, loaded.report.file, one_line(importer.GetErrorString()));
    }
    if (!log.data_loss().empty()) {
        throw file_error(ErrorCode::parse, loaded.report.file, log.data_loss());
    }
    loaded.report.format = format_name(*scene);
    loaded.report.warning_count = log.message_count();
    loaded.report.warnings = log.messages();
    append_scene(loaded, *scene, with_attributes ? &answer.attributes : nullptr);
    check_has_triangles(loaded);
}

/// Limits of memory and CPU time. Assimp needs far less of either for a valid file.
IsolationLimits limits_for(std::uint64_t file_bytes) {
    constexpr std::uint64_t megabyte = std::uint64_t{1} << 20;
    return {.memory_bytes = 1024 * megabyte + 500 * file_bytes,
            .cpu_seconds = 20 + 20 * (file_bytes / megabyte)};
}

std::string import_isolated(const std::filesystem::path& file, std::uint64_t file_bytes,
                            bool with_attributes) {
    AssimpLog log;  // created before the fork: the copy must not wait for a lock
    const auto work = [&] {
        ImportAnswer answer;
        answer.loaded.report.file = file.string();
        try {
            import_scene(file, log, answer, with_attributes);
        } catch (const Error& error) {
            answer.set_error(error);
        } catch (const std::bad_alloc&) {
            answer.set_error(file_error(ErrorCode::limit, file.string(),
                                        "Assimp takes too much memory for a file of this size"));
        } catch (const std::exception& error) {
            answer.set_error(
                file_error(ErrorCode::parse, file.string(), "Assimp: " + one_line(error.what())));
        }
        return to_bytes(answer);
    };
    try {
        IsolatedResult result = run_isolated(work, limits_for(file_bytes));
        if (result.failure.empty()) return std::move(result.bytes);
        throw Error(ErrorCode::parse, "Assimp " + result.failure + ": the file is damaged");
    } catch (const Error& error) {
        throw file_error(error.code(), file.string(), error.what());
    }
}

}  // namespace

bool can_load_scene_files() noexcept {
    return true;
}

std::string_view missing_scene_formats() noexcept {
    return "";
}

bool is_scene_file_extension(const std::string& extension) {
    return Assimp::Importer().IsExtensionSupported(extension);
}

LoadedMesh load_scene_file(const std::filesystem::path& file, MeshAttributes* attributes) {
    const InputFile input(file);  // throws if it is no regular file, or empty
    const std::string bytes = import_isolated(file, input.stored_bytes(), attributes != nullptr);
    ImportAnswer answer = import_answer_from(bytes, input.name());
    if (attributes != nullptr) *attributes = std::move(answer.attributes);
    return std::move(answer.loaded);
}

}  // namespace coppice::inline v0
