#include "coppice/io/load_mesh.h"

#include "coppice/base/error.h"
#include "coppice/base/timer.h"
#include "coppice/io/mesh_attributes.h"

#include "base/out_of_memory.h"
#include "io/count_load_issues.h"
#include "io/input_file.h"
#include "io/load_obj.h"
#include "io/load_off.h"
#include "io/load_ply.h"
#include "io/load_scene_file.h"
#include "io/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace coppice::inline v0 {

namespace {

/// The extension that selects the format, in lower case: ".stl", ".ply.gz".
std::string format_extension(const std::filesystem::path& file) {
    std::string extension = to_lower(file.extension().string());
    if (extension == ".gz") {
        extension.insert(0, to_lower(file.stem().extension().string()));
    }
    return extension;
}

/// The extension for a file without one, recognized by its first bytes; empty if they are unknown.
std::string extension_by_contents(const std::filesystem::path& file) {
    constexpr std::size_t enough = 256;
    InputFile input(file);
    std::string begin(input.read(enough));
    begin.erase(0, begin.find_first_not_of(" \t\r\n"));
    if (begin.starts_with("ply")) return ".ply";
    if (begin.substr(0, begin.find_first_of(" \r\n")).ends_with("OFF")) return ".off";
    const std::string word = begin.substr(0, begin.find_first_of(" \t\r\n"));
    constexpr std::array statements{"v", "vn", "vt", "vp",     "f",     "o",
                                    "g", "s",  "l",  "mtllib", "usemtl"};
    const bool is_obj = begin.starts_with('#') ||
                        std::find(statements.begin(), statements.end(), word) != statements.end();
    return is_obj ? ".obj" : "";
}

LoadedMesh load_by_extension(const std::filesystem::path& file, MeshAttributes* attributes) {
    std::string extension = format_extension(file);
    if (extension.empty()) extension = extension_by_contents(file);
    if (extension.empty()) {
        throw file_error(ErrorCode::unsupported, file.string(),
                         "the name has no extension, and the contents are not OBJ, PLY or OFF: add "
                         "the extension");
    }
    if (extension == ".obj" || extension == ".obj.gz") {
        return load_obj(file, attributes);
    }
    if (extension == ".ply" || extension == ".ply.gz") {
        return load_ply(file, attributes);
    }
    if (extension == ".off") {
        return load_off(file);
    }
    if (is_scene_file_extension(extension)) {
        return load_scene_file(file, attributes);
    }
    throw file_error(ErrorCode::unsupported, file.string(),
                     fmt::format("unknown mesh file extension {}{}", in_quotes(extension),
                                 missing_scene_formats()));
}

}  // namespace

TriangleMesh load_mesh(const std::filesystem::path& file, LoadReport* report,
                       MeshAttributes* attributes) {
    const Timer timer;
    return with_memory_errors(file, [&] {
        const std::uint64_t file_bytes = regular_file_bytes(file);
        if (attributes != nullptr) *attributes = {};
        LoadedMesh loaded = load_by_extension(file, attributes);
        if (report != nullptr) {
            *report = std::move(loaded.report);
            report->file_bytes = file_bytes;
            report->vertex_count = loaded.mesh.vertices.size();
            report->triangle_count = loaded.mesh.triangles.size();
            count_load_issues(loaded.mesh.view(), *report);
            report->load_seconds = timer.seconds();
        }
        return std::move(loaded.mesh);
    });
}

}  // namespace coppice::inline v0
