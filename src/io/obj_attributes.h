#pragma once

#include "coppice/io/mesh_attributes.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace coppice::inline v0 {

/// Collects the attributes in an OBJ file: normals (vn) and materials (mtllib, usemtl).
class ObjAttributes {
public:
    /// Collects into `attributes`. `file` is the path of the OBJ file; material libraries are found
    /// relative to it.
    ObjAttributes(std::string_view file, MeshAttributes& attributes)
        : file_(file), attributes_(attributes) {}

    /// Processes a statement. Returns false if it is of no kind that is collected here.
    bool take_statement(std::string_view keyword, std::string_view rest);

    /// Adds a face that was cut into a fan of triangles. `normals` are its corners' normal indices
    /// as in the file: from 1, relative if negative, 0 for none.
    void add_face(std::span<const std::int64_t> normals);

    /// Reads the material libraries and looks up the used materials. Call it at the end of the
    /// file.
    void finish();

private:
    void use_material(std::string_view name);
    void load_libraries(std::string_view names);
    void load_library(std::string_view name);
    void drop_unknown_normals();
    void find_materials();
    void warn(std::string message);

    std::string file_;
    MeshAttributes& attributes_;
    std::unordered_map<std::string, std::uint32_t> used_;  ///< names to indices of materials
    std::uint32_t material_ = MeshAttributes::none;        ///< material of the following faces
    std::vector<std::string> libraries_;                   ///< `mtllib` lines
    std::vector<Material> known_;                          ///< materials defined in the libraries
    std::uint64_t malformed_normal_count_ = 0;
};

}  // namespace coppice::inline v0
