#include "coppice/builders/method.h"

#include "coppice/base/named.h"

#include <array>

namespace coppice::inline v0 {
namespace {

// Planes that cut off empty space earn a little more than the heuristic gives them: with less or
// more of it, the trees cost more (docs/decisions/0004).
constexpr SahCostModel cost{.empty_bonus = 0.2};

// How far splitting goes on while it pays. The last bit of it gains a fraction of a percent and
// takes much of the time (docs/decisions/0004).
struct Effort {
    std::uint32_t min_split;
    std::uint32_t max_duplication;
};

constexpr Effort thorough{1, 64};
constexpr Effort usual{3, 6};
constexpr Effort quick{4, 4};

// A k-d tree built from all primitives until no split pays.
BuildOptions direct(const char* rule, Effort effort) {
    return {.split = {.rule = rule,
                      .termination = Termination::sah,
                      .min_split = effort.min_split,
                      .max_duplication = effort.max_duplication},
            .leaf_refinement = LeafRefinement::none,
            .cost = cost};
}

BuildOptions exact() {
    return direct("exact", thorough);
}

BuildOptions binned() {
    return direct("binned", usual);
}

BuildOptions sampled() {
    return {.sample = {.rate = 0.01},
            .split = {.rule = "binned",
                      .max_leaf = 64,
                      .bad_refines = 1,
                      .min_split = quick.min_split,
                      .max_duplication = quick.max_duplication},
            .leaf_refinement = LeafRefinement::kd,
            .cost = cost};
}

BuildOptions subsampled() {
    return direct("subsampled", usual);
}

BuildOptions adaptive() {
    return direct("adaptive", usual);
}

BuildOptions sweep() {
    return {.leaf_refinement = LeafRefinement::none};
}

template <Bvh8Preset preset>
BuildOptions bvh8() {
    const bool is_sampled = preset == Bvh8Preset::fast || preset == Bvh8Preset::balanced;
    const double rate = is_sampled ? 0.01 : 1.0;
    return {.sample = {.rate = rate, .sampler = "weighted"}, .bvh8 = {.preset = preset}};
}

constexpr std::array methods{
    Method{"exact", "k-d tree, every plane of all primitives considered: the reference for quality",
           TreeKind::kd, exact},
    Method{"binned", "k-d tree, planes from bins, moved to the best near by", TreeKind::kd, binned},
    Method{"sampled", "k-d tree, upper levels from a sample of 1 %, built on with all primitives",
           TreeKind::kd, sampled},
    Method{"subsampled", "k-d tree, each plane from a sample of its node", TreeKind::kd,
           subsampled},
    Method{"adaptive", "k-d tree, 8 uniform planes and 8 where the cost changes most", TreeKind::kd,
           adaptive},
    Method{"sweep", "k-d tree of the thesis: longest axis first, 32 primitives a leaf",
           TreeKind::kd, sweep},
    Method{"fast", "8-wide tree in the least time", TreeKind::bvh8, bvh8<Bvh8Preset::fast>},
    Method{"balanced", "8-wide tree between fast and quality", TreeKind::bvh8,
           bvh8<Bvh8Preset::balanced>},
    Method{"quality", "8-wide tree for many rays", TreeKind::bvh8, bvh8<Bvh8Preset::quality>},
    Method{"auto", "fast, or quality for 30 rays a triangle and more", TreeKind::bvh8,
           bvh8<Bvh8Preset::automatic>},
};

}  // namespace

std::span<const Method> method_registry() {
    return methods;
}

const Method& find_method(std::string_view name) {
    return find_named(method_registry(), name, "method");
}

}  // namespace coppice::inline v0
