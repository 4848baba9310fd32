#pragma once

#include "coppice/base/error.h"
#include "coppice/io/mesh_attributes.h"

#include "io/loaded_mesh.h"

#include <string>
#include <string_view>

namespace coppice::inline v0 {

/// What the process that imports a file says to the one that asked: a mesh, or an error and
/// what there was of a mesh before.
struct ImportAnswer {
    LoadedMesh loaded;
    MeshAttributes attributes;
    std::string error;  ///< empty if there is a mesh
    int error_code = 0;

    void set_error(const Error& failure) {
        error = failure.what();
        error_code = static_cast<int>(failure.code());
    }
};

[[nodiscard]] std::string to_bytes(const ImportAnswer& answer);

/// The answer in `bytes`, which are not trusted. Throws the Error that is in it, and
/// Error(parse) naming `file` if any of its indices leads nowhere.
[[nodiscard]] ImportAnswer import_answer_from(std::string_view bytes, std::string_view file);

}  // namespace coppice::inline v0
