#pragma once

#include "coppice/cost/sah_cost_model.h"
#include "coppice/export.h"
#include "coppice/sample/sampler.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>

namespace coppice::inline v0 {

class SplitFinder;

/// What a primitive's box becomes when a plane cuts it.
enum class Clipping {
    perfect,      ///< the box of the primitive's part on that side (perfect splits)
    bounding_box  ///< the box cut at the plane
};

/// What a sampled primitive counts in the costs and leaf sizes of the sampled tree.
enum class SampleWeighting {
    sampled,  ///< one, as in the thesis
    expected  ///< as many as it stands for: 1 / its probability to be drawn, in steps of 1/256
};

/// When a node of the sampled tree becomes a leaf.
enum class Termination {
    limits,  ///< at max_leaf primitives, or after bad_refines splits that do not pay
    sah      ///< when no split on any axis costs less than the leaf
};

/// When and where the sampled tree is split. Source: [Tsiompikas2022] sec. 4.3.1.
struct SplitOptions {
    std::string rule = "sah";     ///< a name of split_finder_registry()
    int max_depth = 50;           ///< leaves are no deeper; in [0, 60]
    std::uint32_t max_leaf = 32;  ///< no node with at most so many primitives is split; >= 1
    int bad_refines = 3;          ///< the split that would be the n-th on its path to cost more
                                  ///< than the leaf is refused; >= 1
    Clipping clipping = Clipping::perfect;  ///< what is done with a primitive that a plane cuts
    SampleWeighting sample_weighting =
        SampleWeighting::sampled;                   ///< what a sampled primitive counts
    Termination termination = Termination::limits;  ///< when a node becomes a leaf
    /// Where splits go on as long as they pay, in a build that stops so and in growth: nodes of
    /// fewer primitives are not split; >= 1.
    std::uint32_t min_split = 1;
    /// There, too: references that a primitive may become, on average along a path; >= 1.
    std::uint32_t max_duplication = std::numeric_limits<std::uint32_t>::max();
    std::shared_ptr<const SplitFinder> custom_rule = {};  ///< one of your own, instead of `rule`
};

/// How the refilled leaves go on.
enum class LeafRefinement {
    none,  ///< they do not: the thesis's tree
    kd     ///< each is built on as a k-d tree until no split pays
};

/// All that build_kd_tree() depends on, beside the primitives.
struct KdOptions {
    SampleOptions sample;  ///< which primitives the tree is built from
    SplitOptions split;    ///< when and where nodes are split
    LeafRefinement leaf_refinement = LeafRefinement::kd;  ///< how the refilled leaves go on
    SahCostModel cost;  ///< what splits are chosen and the tree is measured by
    int threads = 0;    ///< at most so many; 0 = all the hardware has
};

/// Throws Error(invalid_argument) naming the first option outside its range.
COPPICE_EXPORT void require_valid(const KdOptions& options);

/// The stable lower-case name, e.g. "bounding_box".
[[nodiscard]] COPPICE_EXPORT const char* name_of(Clipping clipping) noexcept;

/// The stable lower-case name, e.g. "expected".
[[nodiscard]] COPPICE_EXPORT const char* name_of(SampleWeighting sample_weighting) noexcept;

/// The stable lower-case name, e.g. "limits".
[[nodiscard]] COPPICE_EXPORT const char* name_of(Termination termination) noexcept;

/// The stable lower-case name, e.g. "kd".
[[nodiscard]] COPPICE_EXPORT const char* name_of(LeafRefinement leaf_refinement) noexcept;

}  // namespace coppice::inline v0
