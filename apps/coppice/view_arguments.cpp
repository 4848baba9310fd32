#include "view_arguments.h"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

namespace coppice::app {

void add_camera(CLI::App& parser, render::CameraWish& camera) {
    add_vector(parser, {"--eye", "X,Y,Z", "Where the camera is", "all in view, or in the room"},
               camera.eye);
    add_vector(parser, {"--look-at", "X,Y,Z", "What it looks at", "the middle"}, camera.look_at);
    add_vector(parser, {"--up", "X,Y,Z", "What is up in the image", "y, of flat scenes z"},
               camera.up);
    const auto read_fov = [&camera](const std::string& given) {
        camera.fov =
            parse_number("--fov", given, {0.0, 180.0, "a number in (0, 180)", false, false}, "45");
    };
    parser.add_option_function<std::string>("--fov", read_fov, "Field of view from bottom to top")
        ->type_name("DEGREES")
        ->default_str("45; in a room 60");
}

void add_measured_view(CLI::App& parser, const std::string& default_size, int max_size, int& size,
                       render::CameraWish& camera, std::uint64_t& seed) {
    add_whole(parser, {"--size", "N", "Pixels of the image, each way", default_size}, size, 1,
              max_size);
    add_camera(parser, camera);
    add_whole(parser, {"--seed", "N", "Of the bounces' directions", "1"}, seed, 0,
              std::numeric_limits<std::int64_t>::max());
}

void add_ray_kinds(CLI::App& parser, const OptionText& text,
                   std::span<const lab::RayKindEntry> known, std::vector<lab::RayKind>& kinds) {
    const auto read = [option = text.name, known, &kinds](const std::vector<std::string>& texts) {
        kinds.clear();
        std::vector<std::string_view> names = names_in(known);
        names.insert(names.begin(), "all");
        for (const std::string& name : parse_list(option, texts, "primary,diffuse")) {
            require_name(option, name, names);
            for (const lab::RayKindEntry& entry : known) {
                const bool is_meant = name == "all" || name == entry.name;
                const bool is_new =
                    std::find(kinds.begin(), kinds.end(), entry.kind) == kinds.end();
                if (is_meant && is_new) kinds.push_back(entry.kind);
            }
        }
    };
    add_list_option(parser, text, read);
}

bool has_bounces(std::span<const lab::RayKind> kinds) {
    return std::find(kinds.begin(), kinds.end(), lab::RayKind::diffuse) != kinds.end();
}

void refuse_vain_view(const CLI::App& parser, std::span<const lab::RayKind> kinds) {
    const auto has = [&](lab::RayKind kind) {
        return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
    };
    const bool is_seen =
        has(lab::RayKind::primary) || has(lab::RayKind::shadow) || has(lab::RayKind::diffuse);
    for (const char* const name : {"--eye", "--look-at", "--up", "--fov"}) {
        refuse_vain(parser, name, !is_seen,
                    "no rays begin at the camera; primary, shadow and diffuse ones do");
    }
}

}  // namespace coppice::app
