// Replaces load_scene_file.cpp in builds without Assimp.

#include "coppice/base/error.h"
#include "coppice/io/load_mesh.h"

#include "io/load_scene_file.h"

namespace coppice::inline v0 {

bool can_load_scene_files() noexcept {
    return false;
}

std::string_view missing_scene_formats() noexcept {
    return "; .stl, .gltf, .glb, .dae, .x3d, .3ds, .fbx and others are read by Assimp, which this "
           "build is without: install it (Debian: libassimp-dev) and build coppice with "
           "COPPICE_WITH_ASSIMP=ON";
}

bool is_scene_file_extension(const std::string& /*extension*/) {
    return false;
}

LoadedMesh load_scene_file(const std::filesystem::path& file, MeshAttributes* /*attributes*/) {
    throw file_error(ErrorCode::unsupported, file.string(),
                     "its format is read by Assimp, which this build is without");
}

}  // namespace coppice::inline v0
