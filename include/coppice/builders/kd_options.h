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

/// How a primitive's box is computed when a plane cuts it.
enum class Clipping {
    perfect,      ///< the box of the primitive's part on that side (perfect splits)
    bounding_box  ///< the box cut at the plane
};

/// The weight of a sampled primitive in the costs and leaf sizes of the sampled tree.
enum class SampleWeighting {
    sampled,  ///< 1, as in the thesis
    expected  ///< the inverse of its inclusion probability, in steps of 1/256
};

/// The condition for a node of the sampled tree to become a leaf.
enum class Termination {
    limits,  ///< max_leaf primitives reached, or bad_refines splits did not pay
    sah      ///< no split on any axis costs less than the leaf
};

/// Where the sampled tree is split and when splitting ends.
/// Source: [Tsiompikas2022] sec. 4.3.1.
struct SplitOptions {
    std::string rule = "sah";     ///< name of a split rule, see split_finder_registry()
    int max_depth = 50;           ///< greatest depth of a leaf; in [0, 60]
    std::uint32_t max_leaf = 32;  ///< nodes of at most this many primitives become leaves; >= 1
    int bad_refines = 3;          ///< splits that cost more than the leaf: the n-th one on a
                                  ///< path is refused; >= 1
    Clipping clipping = Clipping::perfect;  ///< box of a primitive that a plane cuts
    SampleWeighting sample_weighting = SampleWeighting::sampled;  ///< weight of a sampled primitive
    Termination termination = Termination::limits;                ///< condition for a leaf
    /// Nodes of fewer primitives are not split; >= 1. Applies with Termination::sah and in
    /// LeafRefinement::kd.
    std::uint32_t min_split = 1;
    /// Limit of the average number of references per primitive along a path; >= 1. Applies with
    /// Termination::sah and in LeafRefinement::kd.
    std::uint32_t max_duplication = std::numeric_limits<std::uint32_t>::max();
    std::shared_ptr<const SplitFinder> custom_rule = {};  ///< your own, instead of `rule`
};

/// How the leaves are refined after the refill.
enum class LeafRefinement {
    none,  ///< not at all: the thesis's tree
    kd     ///< each leaf is split as a k-d tree until no split pays
};

/// All options of build_kd_tree().
struct KdOptions {
    SampleOptions sample;  ///< the sample that the tree is built from
    SplitOptions split;    ///< where nodes are split and when splitting ends
    LeafRefinement leaf_refinement = LeafRefinement::kd;  ///< refinement after the refill
    SahCostModel cost;  ///< for choosing splits and measuring the tree
    int threads = 0;    ///< greatest number of threads; 0 = all hardware threads
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
