#include "coppice/build/build_options.h"

#include "coppice/base/error.h"
#include "coppice/build/split_finder.h"
#include "coppice/tree/kd_tree.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace coppice {
namespace {

void require(bool holds, std::string_view name, std::int64_t value, std::string_view range) {
    if (holds) return;
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{} {} is outside {}", name, value, range));
}

}  // namespace

void check(const BuildOptions& options) {
    static_cast<void>(sample_count(1, options.sample.rate));
    static_cast<void>(find_sampler(options.sample.sampler));
    const double share = options.sample.uniform_share;
    if (!(share >= 0.0 && share <= 1.0)) {
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("uniform share {} is outside [0, 1]", share));
    }
    const SplitOptions& split = options.split;
    static_cast<void>(find_split_finder(split.rule));
    require(split.max_depth >= 0 && split.max_depth <= KdTree::max_depth, "max depth",
            split.max_depth, "[0, 60]");
    require(split.max_leaf >= 1, "max leaf", split.max_leaf, "[1, 2^32)");
    require(split.bad_refines >= 1, "bad refines", split.bad_refines, "[1, 2^31)");
    require(split.min_split >= 1, "min split", split.min_split, "[1, 2^32)");
    require(split.max_duplication >= 1, "max duplication", split.max_duplication, "[1, 2^32)");
    require(options.threads >= 0, "threads", options.threads, "[0, 2^31)");
    const WideOptions& wide = options.wide;
    require(wide.cell_size == 0 || wide.cell_size >= 64, "cell size", wide.cell_size,
            "[64, 2^32) and not 0");
    if (!(wide.expected_rays >= 0.0)) {
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("expected rays {} is outside [0, inf]", wide.expected_rays));
    }
    check(options.cost);
}

const char* name_of(Clipping clipping) noexcept {
    return clipping == Clipping::perfect ? "perfect" : "bounding_box";
}

const char* name_of(Counting counting) noexcept {
    return counting == Counting::sampled ? "sampled" : "expected";
}

const char* name_of(Stop stop) noexcept {
    return stop == Stop::limits ? "limits" : "sah";
}

const char* name_of(WidePreset preset) noexcept {
    switch (preset) {
        case WidePreset::automatic:
            return "automatic";
        case WidePreset::fast:
            return "fast";
        case WidePreset::balanced:
            return "balanced";
        case WidePreset::quality:
            return "quality";
    }
    return "unknown";
}

const char* name_of(Growth growth) noexcept {
    return growth == Growth::none ? "none" : "kd";
}

void to_json(nlohmann::json& json, const BuildOptions& options) {
    json = {{"sample",
             {{"rate", options.sample.rate},
              {"sampler", options.sample.sampler},
              {"seed", options.sample.seed},
              {"uniform_share", options.sample.uniform_share}}},
            {"split",
             {{"rule", options.split.rule},
              {"max_depth", options.split.max_depth},
              {"max_leaf", options.split.max_leaf},
              {"bad_refines", options.split.bad_refines},
              {"clipping", name_of(options.split.clipping)},
              {"counting", name_of(options.split.counting)},
              {"stop", name_of(options.split.stop)},
              {"min_split", options.split.min_split},
              {"max_duplication", options.split.max_duplication}}},
            {"growth", name_of(options.growth)},
            {"cost", options.cost},
            {"wide",
             {{"preset", name_of(options.wide.preset)},
              {"expected_rays", options.wide.expected_rays},
              {"cell_size", options.wide.cell_size},
              {"sampled_from", options.wide.sampled_from}}},
            {"threads", options.threads}};
}

}  // namespace coppice
