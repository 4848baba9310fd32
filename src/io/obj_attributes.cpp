// Collects materials and normals of an OBJ file. Errors in them do not fail the loading, because a
// mesh without its material library is still usable. Materials are numbered by first use and looked
// up at the end of the file.

#include "io/obj_attributes.h"

#include "coppice/base/error.h"

#include "io/load_mtl.h"
#include "io/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

namespace coppice::inline v0 {

namespace {

constexpr std::size_t kept_warnings = 16;  // a malicious file could cause millions

/// The path of a material library as named in an OBJ file, which may use Windows separators.
std::filesystem::path library_path(const std::filesystem::path& obj, std::string_view name) {
    std::string path(name);
    std::replace(path.begin(), path.end(), '\\', '/');
    return obj.parent_path() / path;
}

bool is_file(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

}  // namespace

bool ObjAttributes::take_statement(std::string_view keyword, std::string_view rest) {
    if (keyword == "vn") {
        std::array<float, 3> normal{};
        for (float& component : normal) {
            const std::optional<float> value = parse_float(take_word(rest));
            malformed_normal_count_ += value ? 0 : 1;
            component = value.value_or(0.0F);
        }
        attributes_.normals.push_back({normal[0], normal[1], normal[2]});
    } else if (keyword == "usemtl") {
        use_material(trimmed(rest));
    } else if (keyword == "mtllib") {
        const std::string library(trimmed(rest));
        const bool is_new =
            std::find(libraries_.begin(), libraries_.end(), library) == libraries_.end();
        if (is_new) libraries_.push_back(library);
    } else {
        return false;
    }
    return true;
}

void ObjAttributes::use_material(std::string_view name) {
    const auto [used, is_new] = used_.try_emplace(
        std::string(name), static_cast<std::uint32_t>(attributes_.materials.size()));
    if (is_new) attributes_.materials.emplace_back().name = name;
    material_ = used->second;
}

void ObjAttributes::add_face(std::span<const std::int64_t> normals) {
    const auto normal_count = static_cast<std::int64_t>(attributes_.normals.size());
    const auto index_of = [&](std::size_t corner) {
        // Indices out of range are checked at the end: the normal may follow later in the file.
        const std::int64_t given = normals[corner];
        const std::int64_t index = given > 0 ? given - 1 : normal_count + given;
        const bool is_index = given != 0 && index >= 0 && index < MeshAttributes::none;
        return is_index ? static_cast<std::uint32_t>(index) : MeshAttributes::none;
    };
    for (std::size_t i = 2; i < normals.size(); ++i) {
        attributes_.triangle_materials.push_back(material_);
        attributes_.triangle_normals.push_back({index_of(0), index_of(i - 1), index_of(i)});
    }
}

void ObjAttributes::finish() {
    drop_unknown_normals();
    for (const std::string& library : libraries_) {
        load_libraries(library);
    }
    find_materials();
}

void ObjAttributes::drop_unknown_normals() {
    if (malformed_normal_count_ > 0) {
        warn(fmt::format("{}: {} malformed numbers in normals, read as 0", file_,
                         malformed_normal_count_));
    }
    if (attributes_.normals.empty()) {
        attributes_.triangle_normals = {};
        return;
    }
    std::uint64_t unknown_count = 0;
    for (TriangleIndices& triangle : attributes_.triangle_normals) {
        for (std::uint32_t& index : triangle) {
            if (index == MeshAttributes::none || index < attributes_.normals.size()) continue;
            index = MeshAttributes::none;
            ++unknown_count;
        }
    }
    if (unknown_count > 0) {
        warn(
            fmt::format("{}: {} corners with normals out of range, ignored", file_, unknown_count));
    }
}

void ObjAttributes::load_libraries(std::string_view names) {
    // The name may contain blanks, or there may be several names. Existing files decide.
    if (is_file(library_path(file_, names))) {
        load_library(names);
        return;
    }
    for (std::string_view name = take_word(names); !name.empty(); name = take_word(names)) {
        load_library(name);
    }
}

void ObjAttributes::load_library(std::string_view name) {
    try {
        const auto materials = load_mtl(library_path(file_, name), attributes_.warnings);
        known_.insert(known_.end(), materials.begin(), materials.end());
    } catch (const Error& error) {
        warn(fmt::format("{}; its materials are grey", error.what()));
    }
}

void ObjAttributes::find_materials() {
    std::unordered_map<std::string_view, const Material*> by_name;
    for (const Material& material : known_) {
        by_name.try_emplace(material.name, &material);
    }
    std::vector<std::string_view> unknown;
    for (Material& material : attributes_.materials) {
        const auto known = by_name.find(material.name);
        if (known == by_name.end()) {
            unknown.push_back(material.name);
        } else {
            material = *known->second;
        }
    }
    if (attributes_.materials.empty()) attributes_.triangle_materials = {};
    if (!unknown.empty() && (!known_.empty() || libraries_.empty())) {
        warn(fmt::format(
            "{}: {} of {} materials are not defined in any material file and become grey; the "
            "first: {}",
            file_, unknown.size(), attributes_.materials.size(), in_quotes(unknown.front())));
    }
    if (attributes_.warnings.size() > kept_warnings) {
        const std::size_t dropped_count = attributes_.warnings.size() - kept_warnings;
        attributes_.warnings.resize(kept_warnings);
        warn(fmt::format("{}: {} more warnings", file_, dropped_count));
    }
}

void ObjAttributes::warn(std::string message) {
    attributes_.warnings.push_back(std::move(message));
}

}  // namespace coppice::inline v0
