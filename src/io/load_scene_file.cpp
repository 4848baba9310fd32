#include "io/load_scene_file.h"

#include "coppice/base/error.h"

#include "io/assimp_log.h"
#include "io/input_file.h"
#include "io/text.h"

#include <assimp/Importer.hpp>
#include <assimp/commonMetaData.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace coppice {

namespace {

[[noreturn]] void fail_in_mesh(const LoadedMesh& loaded, const aiMesh& mesh,
                               const std::string& message) {
    throw file_error(ErrorCode::parse, loaded.report.file,
                     fmt::format("mesh {}: {}", in_quotes(mesh.mName.C_Str()), message));
}

void append_vertices(LoadedMesh& loaded, const aiMesh& mesh, const aiMatrix4x4& to_world) {
    for (unsigned id = 0; id < mesh.mNumVertices; ++id) {
        const aiVector3D position = to_world * mesh.mVertices[id];
        if (!std::isfinite(position.x) || !std::isfinite(position.y) ||
            !std::isfinite(position.z)) {
            fail_in_mesh(loaded, mesh,
                         fmt::format("vertex {}: position ({}, {}, {}) is not finite", id,
                                     position.x, position.y, position.z));
        }
        add_vertex(loaded, {position.x, position.y, position.z});
    }
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

/// Appends the meshes of all nodes; a mesh that several nodes show comes several times.
void append_scene(LoadedMesh& loaded, const aiScene& scene) {
    std::vector<std::pair<const aiNode*, aiMatrix4x4>> open = {{scene.mRootNode, aiMatrix4x4()}};
    while (!open.empty()) {
        const auto [node, parent_to_world] = open.back();
        open.pop_back();
        const aiMatrix4x4 to_world = parent_to_world * node->mTransformation;
        for (const unsigned mesh : std::span(node->mMeshes, node->mNumMeshes)) {
            append_mesh(loaded, *scene.mMeshes[mesh], to_world);
        }
        // Backwards onto the stack: the meshes come in the order of the file.
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

}  // namespace

bool is_scene_file_extension(const std::string& extension) {
    return Assimp::Importer().IsExtensionSupported(extension);
}

LoadedMesh load_scene_file(const std::filesystem::path& file) {
    LoadedMesh loaded;
    loaded.report.file = InputFile(file).name();  // refuses what is no file or empty
    AssimpLog log;
    Assimp::Importer importer;
    // No post-processing: vertices keep their order, and polygons are cut as in other formats.
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
    append_scene(loaded, *scene);
    check_has_triangles(loaded);
    return loaded;
}

}  // namespace coppice
