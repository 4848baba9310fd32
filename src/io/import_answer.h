#pragma once

#include "coppice/base/error.h"
#include "coppice/io/mesh_attributes.h"

#include "io/loaded_mesh.h"

#include <string>
#include <string_view>

namespace coppice::inline v0 {

/// The answer of the process that imports a file: a mesh, or an error and the part of the report
/// before it.
struct ImportAnswer {
    LoadedMesh loaded;
    MeshAttributes attributes;
    std::string error;  ///< message of the error; empty if there is a mesh
    int error_code = 0;

    void set_error(const Error& failure) {
        error = failure.what();
        error_code = static_cast<int>(failure.code());
    }
};

[[nodiscard]] std::string to_bytes(const ImportAnswer& answer);

/// Decodes an answer from untrusted bytes. Throws the Error that the answer contains, and
/// Error(parse) naming `file` if any index is out of range.
[[nodiscard]] ImportAnswer import_answer_from(std::string_view bytes, std::string_view file);

}  // namespace coppice::inline v0
