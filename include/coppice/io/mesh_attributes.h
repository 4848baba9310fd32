#pragma once

#include "coppice/geom/triangle_mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace coppice::inline v0 {

/// How a surface looks, in the terms of MTL, the material files of OBJ. Colours are linear.
struct Material {
    std::string name;                 ///< in the file
    Vec3f diffuse{0.6F, 0.6F, 0.6F};  ///< Kd
    Vec3f specular;                   ///< Ks
    Vec3f emission;                   ///< Ke
    float shininess = 0.0F;           ///< Ns, the exponent of highlights
    int illumination = 1;             ///< illum: 2 has highlights, 3 and above reflects
};

/// What a file tells of its triangles beside their corners, as far as it does.
struct MeshAttributes {
    /// An index of nothing: a triangle without material, a corner without normal.
    static constexpr std::uint32_t none = 0xffffffff;

    /// All that the file defines.
    std::vector<Material> materials;
    /// One index into `materials`, or `none`, per triangle; empty if there are no materials.
    std::vector<std::uint32_t> triangle_materials;
    /// Not normalised; one that is zero or not finite is none. Empty if the file has none.
    std::vector<Vec3f> normals;
    /// Indices into `normals`, or `none`, of each triangle's corners. If it is empty, normals
    /// belong to the vertices: normals[v] to vertex v.
    std::vector<TriangleIndices> triangle_normals;
    /// What could not be read, a line each: it is left out, and does not fail the loading.
    std::vector<std::string> warnings;
};

}  // namespace coppice::inline v0
