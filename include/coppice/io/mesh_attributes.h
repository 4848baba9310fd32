#pragma once

#include "coppice/geom/triangle_mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace coppice::inline v0 {

/// The appearance of a surface, in the terms of MTL, the material files of OBJ. Colours are linear.
struct Material {
    std::string name;                 ///< name in the file
    Vec3f diffuse{0.6F, 0.6F, 0.6F};  ///< Kd
    Vec3f specular;                   ///< Ks
    Vec3f emission;                   ///< Ke
    float shininess = 0.0F;           ///< Ns, the exponent of highlights
    int illumination = 1;             ///< illum: 2 has highlights, 3 and above reflects
};

/// Materials and normals of a mesh, as far as its file has them.
struct MeshAttributes {
    /// The index that stands for no material or no normal.
    static constexpr std::uint32_t none = 0xffffffff;

    /// All materials that the file defines.
    std::vector<Material> materials;
    /// One index into `materials`, or `none`, per triangle; empty if there are no materials.
    std::vector<std::uint32_t> triangle_materials;
    /// Normals, not normalized. A normal that is zero or not finite counts as missing. Empty if the
    /// file has none.
    std::vector<Vec3f> normals;
    /// Indices into `normals`, or `none`, for each triangle's corners. If empty, normals belong to
    /// vertices: normals[v] is the normal of vertex v.
    std::vector<TriangleIndices> triangle_normals;
    /// One line for each thing that could not be read and was left out. None of them makes loading
    /// fail.
    std::vector<std::string> warnings;
};

}  // namespace coppice::inline v0
