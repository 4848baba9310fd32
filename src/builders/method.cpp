#include "coppice/builders/method.h"

#include "coppice/base/error.h"
#include "coppice/base/named.h"

#include "builders/bvh8/plan.h"

#include <array>
#include <string>
#include <utility>

namespace coppice::inline v0 {
namespace {

// The empty bonus is slightly greater than the heuristic's. With a smaller or greater one, the
// trees cost more (docs/decisions/0004).
SahCostModel tuned_cost() {
    return {.empty_bonus = 0.2};
}

// The limits of splitting while it pays. The last splits gain a fraction of a percent and take much
// of the time (docs/decisions/0004).
struct Effort {
    std::uint32_t min_split;
    std::uint32_t max_duplication;
};

constexpr Effort thorough{1, 64};
constexpr Effort usual{3, 6};
constexpr Effort quick{4, 4};

// Options of a k-d tree that is built from all primitives until no split pays.
KdOptions direct(const char* rule, Effort effort) {
    return {.split = {.rule = rule,
                      .termination = Termination::sah,
                      .min_split = effort.min_split,
                      .max_duplication = effort.max_duplication},
            .leaf_refinement = LeafRefinement::none,
            .cost = tuned_cost()};
}

BuildOptions exact() {
    return direct("exact", thorough);
}

BuildOptions binned() {
    return direct("binned", usual);
}

BuildOptions sampled() {
    return KdOptions{.sample = {.rate = 0.01},
                     .split = {.rule = "binned",
                               .max_leaf = 64,
                               .bad_refines = 1,
                               .min_split = quick.min_split,
                               .max_duplication = quick.max_duplication},
                     .leaf_refinement = LeafRefinement::kd,
                     .cost = tuned_cost()};
}

BuildOptions subsampled() {
    return direct("subsampled", usual);
}

BuildOptions adaptive() {
    return direct("adaptive", usual);
}

BuildOptions sweep() {
    return KdOptions{.leaf_refinement = LeafRefinement::none};
}

template <Bvh8Preset preset>
BuildOptions bvh8() {
    const bool is_sampled = preset == Bvh8Preset::fast || preset == Bvh8Preset::balanced;
    const double rate = is_sampled ? 0.01 : 1.0;
    return Bvh8Options{.sample = {.rate = rate, .sampler = std::string(bvh8::preset_sampler)},
                       .preset = preset};
}

constexpr std::array methods{
    Method{"exact", "k-d tree, every plane of all primitives considered: the reference for quality",
           exact},
    Method{"binned", "k-d tree, planes from bins, moved to the best end nearby", binned},
    Method{"sampled", "k-d tree, upper levels from a sample of 1 %, refined with all primitives",
           sampled},
    Method{"subsampled", "k-d tree, each plane from a sample of its node", subsampled},
    Method{"adaptive", "k-d tree, 8 uniform planes and 8 where the cost changes most", adaptive},
    Method{"sweep", "k-d tree of the thesis: longest axis first, 32 primitives a leaf", sweep},
    Method{"fast", "8-wide tree in the least time", bvh8<Bvh8Preset::fast>},
    Method{"balanced", "8-wide tree between fast and quality", bvh8<Bvh8Preset::balanced>},
    Method{"quality", "8-wide tree for many rays", bvh8<Bvh8Preset::quality>},
    Method{"auto", "fast, or quality for 30 rays a triangle and more", bvh8<Bvh8Preset::automatic>},
};

template <typename Options>
Options options_for(const Method& method, std::string_view trees) {
    BuildOptions options = method.options();
    if (auto* const found = std::get_if<Options>(&options)) return std::move(*found);
    throw Error(ErrorCode::invalid_argument, "the method '" + std::string(method.name) +
                                                 "' does not build " + std::string(trees));
}

}  // namespace

std::span<const Method> method_registry() {
    return methods;
}

KdOptions Method::kd_options() const {
    return options_for<KdOptions>(*this, "k-d trees");
}

Bvh8Options Method::bvh8_options() const {
    return options_for<Bvh8Options>(*this, "8-wide trees");
}

bool Method::is_automatic() const {
    const BuildOptions named = options();
    const auto* const bvh8 = std::get_if<Bvh8Options>(&named);
    return bvh8 != nullptr && bvh8->preset == Bvh8Preset::automatic;
}

const Method& find_method(std::string_view name) {
    return find_named(method_registry(), name, "method");
}

}  // namespace coppice::inline v0
