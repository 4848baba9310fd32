#include "coppice/builders/build_options.h"

#include "coppice/base/error.h"
#include "coppice/builders/split_finder.h"
#include "coppice/tree/kd_tree.h"

#include <fmt/format.h>

namespace coppice::inline v0 {
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
    const Bvh8Options& wide = options.bvh8;
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

const char* name_of(SampleWeighting sample_weighting) noexcept {
    return sample_weighting == SampleWeighting::sampled ? "sampled" : "expected";
}

const char* name_of(Termination termination) noexcept {
    return termination == Termination::limits ? "limits" : "sah";
}

const char* name_of(Bvh8Preset preset) noexcept {
    switch (preset) {
        case Bvh8Preset::automatic:
            return "automatic";
        case Bvh8Preset::fast:
            return "fast";
        case Bvh8Preset::balanced:
            return "balanced";
        case Bvh8Preset::quality:
            return "quality";
    }
    return "unknown";
}

const char* name_of(LeafRefinement leaf_refinement) noexcept {
    return leaf_refinement == LeafRefinement::none ? "none" : "kd";
}

}  // namespace coppice::inline v0
