#include "experiment/experiment_options.h"

#include "coppice/base/error.h"
#include "coppice/base/named.h"
#include "coppice/base/parallel.h"
#include "coppice/builders/split_finder.h"
#include "coppice/sample/sampler.h"

#include "experiment/builders.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::lab {

namespace {

using nlohmann::json;

constexpr std::array<PrimitiveKindEntry, 2> kinds{{
    {"points", "the mesh's distinct vertices, shuffled: the thesis's primitives",
     PrimitiveKind::points},
    {"triangles", "the mesh's triangles", PrimitiveKind::triangles},
}};

[[noreturn]] void fail(const std::string& message) {
    throw Error(ErrorCode::invalid_argument, message);
}

template <typename T>
bool has_duplicates(std::vector<T> values) {
    std::sort(values.begin(), values.end());
    return std::adjacent_find(values.begin(), values.end()) != values.end();
}

void check_percents(const std::vector<double>& percents) {
    if (percents.empty()) fail("an experiment needs at least one rate");
    for (const double percent : percents) {
        if (!(percent > 0.0 && percent <= 100.0)) {
            fail(fmt::format("rate {} is not a percentage in (0, 100]", percent));
        }
    }
    if (has_duplicates(percents)) fail("a rate is given twice");
}

std::vector<std::string_view> kind_names(const std::vector<PrimitiveKind>& primitives) {
    std::vector<std::string_view> names;
    names.reserve(kinds.size());
    for (const PrimitiveKindEntry& entry : kinds) {
        if (primitives.empty()) names.push_back(entry.name);
    }
    for (const PrimitiveKind kind : primitives) {
        names.push_back(name_of(kind));
    }
    return names;
}

std::vector<std::string_view> ray_names(const std::vector<RayKind>& rays) {
    std::vector<std::string_view> names;
    names.reserve(rays.size());
    for (const RayKind kind : rays) {
        names.push_back(name_of(kind));
    }
    return names;
}

/// The samplers of protocols.
std::vector<std::string> resolved_samplers(const ExperimentOptions& options) {
    if (!options.samplers.empty()) return options.samplers;
    return {std::string(sampler_registry().front().name)};
}

/// How many rays there are, and what is given of where they come from.
void put_view(const ExperimentOptions& options, json& to) {
    to["size"] = options.size;
    if (options.camera.fov) to["fov"] = *options.camera.fov;
    const auto put = [&](const char* key, const std::optional<Vec3f>& v) {
        if (v) to[key] = {v->x, v->y, v->z};
    };
    put("eye", options.camera.eye);
    put("look_at", options.camera.look_at);
    put("up", options.camera.up);
}

void read_view(const json& from, ExperimentOptions& options) {
    from.at("size").get_to(options.size);
    if (from.contains("fov")) options.camera.fov = from.at("fov").get<double>();
    const auto read = [&](const char* key) -> std::optional<Vec3f> {
        if (!from.contains(key)) return std::nullopt;
        const json& v = from.at(key);
        return Vec3f{v.at(0), v.at(1), v.at(2)};
    };
    options.camera.eye = read("eye");
    options.camera.look_at = read("look_at");
    options.camera.up = read("up");
}

/// Reads names and finds each in a registry; `kind_of` takes what is wanted of an entry.
template <typename Entry, typename Kind>
std::vector<Kind> read_kinds(const json& names, std::span<const Entry> registry, const char* what,
                             Kind Entry::*kind) {
    std::vector<Kind> read;
    for (const json& name : names) {
        read.push_back(find_named(registry, name.get<std::string>(), what).*kind);
    }
    return read;
}

/// A share in percent, with the digits that were given: 0.07 * 100 is not 7.
double percent_of(double share) {
    return std::nearbyint(share * 1e14) / 1e12;
}

std::vector<std::string> path_names(const std::vector<std::filesystem::path>& paths) {
    std::vector<std::string> names;
    names.reserve(paths.size());
    for (const auto& path : paths) {
        names.push_back(path.string());
    }
    return names;
}

}  // namespace

std::span<const PrimitiveKindEntry> primitive_kind_registry() {
    return kinds;
}

std::string_view name_of(PrimitiveKind kind) noexcept {
    return kinds[static_cast<std::size_t>(kind)].name;
}

void check(const ExperimentOptions& options) {
    if (options.scenes.empty()) fail("an experiment needs at least one scene");
    if (options.protocols.empty()) fail("an experiment needs at least one protocol");
    static_cast<void>(builders_of(options));
    for (const std::string& name : options.samplers) {
        static_cast<void>(find_sampler(name));
    }
    if (has_duplicates(options.protocols)) fail("a protocol is given twice");
    if (has_duplicates(options.methods)) fail("a method is given twice");
    if (has_duplicates(options.samplers)) fail("a sampler is given twice");
    if (has_duplicates(options.rays)) fail("a kind of rays is given twice");
    if (has_duplicates(options.primitives)) fail("a kind of primitive is given twice");
    check_percents(options.percents);
    if (options.seed_count < 1 || options.seed_count > ExperimentOptions::max_seed_count) {
        fail(fmt::format("the number of seeds {} is not in [1, {}]", options.seed_count,
                         ExperimentOptions::max_seed_count));
    }
    if (!(options.tolerance >= 0.0) || !std::isfinite(options.tolerance)) {
        fail(fmt::format("the tolerance {} is not finite and >= 0", options.tolerance));
    }
    if (options.size < 1 || options.size > ExperimentOptions::max_size) {
        fail(fmt::format("size {} is outside [1, {}]", options.size, ExperimentOptions::max_size));
    }
    require_valid(options.build);
}

void to_json(json& to, const ExperimentOptions& options) {
    const KdOptions& build = options.build;
    to = {{"scenes", path_names(options.scenes)},
          {"primitives", kind_names(options.primitives)},
          {"protocols", options.protocols},
          {"methods", options.methods},
          {"samplers", resolved_samplers(options)},
          {"rates", options.percents},
          {"rays", ray_names(options.rays)},
          {"split", build.split.rule},
          {"seeds", options.seed_count},
          {"tolerance", percent_of(options.tolerance)},
          {"traversal_cost", build.cost.traversal},
          {"intersection_cost", build.cost.intersection},
          {"empty_bonus", build.cost.empty_bonus},
          {"max_depth", build.split.max_depth},
          {"max_leaf", build.split.max_leaf},
          {"bad_refines", build.split.bad_refines},
          {"clipping", name_of(build.split.clipping)},
          {"threads", build.threads > 0 ? build.threads : hardware_thread_count()},
          {"pictures", options.report_parts == ReportParts::all},
          {"out", options.out.string()}};
    if (options.memory_limit_bytes > 0) to["memory_limit_bytes"] = options.memory_limit_bytes;
    if (!options.rays.empty()) put_view(options, to);
}

json given_options_json(const ExperimentOptions& options) {
    json given = options;
    if (options.primitives.empty()) given["primitives"] = json::array();
    given["samplers"] = options.samplers;
    given["threads"] = options.build.threads;
    return given;
}

ExperimentOptions experiment_options_of(const json& from) {
    ExperimentOptions options;
    for (const json& scene : from.at("scenes")) {
        options.scenes.emplace_back(scene.get<std::string>());
    }
    options.primitives = read_kinds(from.at("primitives"), primitive_kind_registry(),
                                    "kind of primitive", &PrimitiveKindEntry::kind);
    from.at("protocols").get_to(options.protocols);
    from.at("methods").get_to(options.methods);
    from.at("samplers").get_to(options.samplers);
    from.at("rates").get_to(options.percents);
    options.rays =
        read_kinds(from.at("rays"), ray_kind_registry(), "kind of rays", &RayKindEntry::kind);
    if (!options.rays.empty()) read_view(from, options);
    from.at("seeds").get_to(options.seed_count);
    options.tolerance = from.at("tolerance").get<double>() / 100.0;
    KdOptions& build = options.build;
    from.at("split").get_to(build.split.rule);
    from.at("traversal_cost").get_to(build.cost.traversal);
    from.at("intersection_cost").get_to(build.cost.intersection);
    from.at("empty_bonus").get_to(build.cost.empty_bonus);
    from.at("max_depth").get_to(build.split.max_depth);
    from.at("max_leaf").get_to(build.split.max_leaf);
    from.at("bad_refines").get_to(build.split.bad_refines);
    const bool is_clipped = from.at("clipping") == name_of(Clipping::perfect);
    build.split.clipping = is_clipped ? Clipping::perfect : Clipping::bounding_box;
    from.at("threads").get_to(build.threads);
    options.memory_limit_bytes = from.value("memory_limit_bytes", std::uint64_t{0});
    const bool has_pictures = from.at("pictures").get<bool>();
    options.report_parts = has_pictures ? ReportParts::all : ReportParts::numbers;
    options.out = from.at("out").get<std::string>();
    return options;
}

}  // namespace coppice::lab
