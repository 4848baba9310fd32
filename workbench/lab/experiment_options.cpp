#include "lab/experiment_options.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"
#include "coppice/build/split_finder.h"
#include "coppice/sample/sampler.h"

#include "lab/named.h"
#include "lab/protocol.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::lab {

namespace {

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
    for (const std::string& name : options.protocols) {
        static_cast<void>(find_protocol(name));
    }
    if (has_duplicates(options.protocols)) fail("a protocol is given twice");
    if (has_duplicates(options.primitives)) fail("a kind of primitive is given twice");
    check_percents(options.percents);
    if (options.seed_count < 1 || options.seed_count > ExperimentOptions::max_seed_count) {
        fail(fmt::format("the number of seeds {} is not in [1, {}]", options.seed_count,
                         ExperimentOptions::max_seed_count));
    }
    if (!(options.tolerance >= 0.0) || !std::isfinite(options.tolerance)) {
        fail(fmt::format("the tolerance {} is not finite and >= 0", options.tolerance));
    }
    check(options.build);
}

void to_json(nlohmann::json& json, const ExperimentOptions& options) {
    const BuildOptions& build = options.build;
    json = {{"scenes", path_names(options.scenes)},
            {"primitives", kind_names(options.primitives)},
            {"protocols", options.protocols},
            {"rates", options.percents},
            {"split", build.split.rule},
            {"sampler", build.sample.sampler},
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
}

ExperimentOptions experiment_options_of(const nlohmann::json& json) {
    ExperimentOptions options;
    for (const nlohmann::json& scene : json.at("scenes")) {
        options.scenes.emplace_back(scene.get<std::string>());
    }
    for (const nlohmann::json& name : json.at("primitives")) {
        options.primitives.push_back(
            find_named(primitive_kind_registry(), name.get<std::string>(), "kind of primitive")
                .kind);
    }
    json.at("protocols").get_to(options.protocols);
    json.at("rates").get_to(options.percents);
    json.at("seeds").get_to(options.seed_count);
    options.tolerance = json.at("tolerance").get<double>() / 100.0;
    BuildOptions& build = options.build;
    json.at("split").get_to(build.split.rule);
    json.at("sampler").get_to(build.sample.sampler);
    json.at("traversal_cost").get_to(build.cost.traversal);
    json.at("intersection_cost").get_to(build.cost.intersection);
    json.at("empty_bonus").get_to(build.cost.empty_bonus);
    json.at("max_depth").get_to(build.split.max_depth);
    json.at("max_leaf").get_to(build.split.max_leaf);
    json.at("bad_refines").get_to(build.split.bad_refines);
    const bool is_clipped = json.at("clipping") == name_of(Clipping::perfect);
    build.split.clipping = is_clipped ? Clipping::perfect : Clipping::bounding_box;
    json.at("threads").get_to(build.threads);
    const bool has_pictures = json.at("pictures").get<bool>();
    options.report_parts = has_pictures ? ReportParts::all : ReportParts::numbers;
    options.out = json.at("out").get<std::string>();
    return options;
}

}  // namespace coppice::lab
