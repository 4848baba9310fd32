#pragma once

#include "coppice/base/error.h"
#include "coppice/io/load_mesh.h"
#include "coppice/io/mesh_attributes.h"

#include "expect.h"

#include <algorithm>
#include <filesystem>
#include <string>

namespace coppice::fuzz {

/// Every index of what was read leads somewhere.
inline void expect_consistent(const TriangleMesh& mesh, const LoadReport& report,
                              const MeshAttributes& attributes) {
    const auto all_below = [](const TriangleIndices& corners, std::size_t count, bool none_too) {
        return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
            return corner < count || (none_too && corner == MeshAttributes::none);
        });
    };
    for (const TriangleIndices& corners : mesh.triangles) {
        expect(all_below(corners, mesh.vertices.size(), false), "corners that exist");
    }
    for (const Vec3f& vertex : mesh.vertices) {
        expect(is_finite(vertex), "finite coordinates");
    }
    expect(report.triangle_count == mesh.triangles.size(), "all triangles in the report");
    expect(report.vertex_count == mesh.vertices.size(), "all vertices in the report");

    const auto& materials = attributes.triangle_materials;
    expect(materials.empty() || materials.size() == mesh.triangles.size(),
           "a material or none for each triangle");
    for (const std::uint32_t material : materials) {
        expect(material < attributes.materials.size() || material == MeshAttributes::none,
               "materials that exist");
    }
    const auto& normals = attributes.triangle_normals;
    expect(normals.empty() || normals.size() == mesh.triangles.size(),
           "normals or none for each triangle");
    for (const TriangleIndices& corners : normals) {
        expect(all_below(corners, attributes.normals.size(), true), "normals that exist");
    }
    expect(!normals.empty() || attributes.normals.empty() ||
               attributes.normals.size() == mesh.vertices.size(),
           "a normal for each vertex");
}

/// Loads a file. It is a consistent mesh or an error of one line that names the file.
inline void load_anything(const std::filesystem::path& file) {
    LoadReport report;
    MeshAttributes attributes;
    try {
        const TriangleMesh mesh = load_mesh(file, &report, &attributes);
        expect_consistent(mesh, report, attributes);
    } catch (const Error& error) {
        const std::string what = error.what();
        expect(what.find_first_of("\n\r") == std::string::npos, "an error of one line");
        expect(what.starts_with(file.string()), "an error that names the file");
    }
}

}  // namespace coppice::fuzz
