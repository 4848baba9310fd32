#pragma once

#include "coppice/cost/cost_model.h"
#include "coppice/export.h"

#include <memory>

namespace coppice::inline v0 {

/// The constants of the surface area heuristic (SAH). Both costs are in the same arbitrary unit of
/// time.
/// Source: [MacDonaldBooth1990], [WaldHavran2006] sec. 3.
struct COPPICE_EXPORT SahCostModel {
    double traversal = 1.0;     ///< cost of one inner node; >= 0
    double intersection = 1.0;  ///< cost of one primitive; > 0
    double empty_bonus = 0.5;   ///< share by which an empty side reduces a split's cost; [0, 1)
    std::shared_ptr<const CostModel> custom = {};  ///< a model of your own, replaces the constants

    /// The cost of one inner node for a ray that meets it.
    [[nodiscard]] double traversal_cost() const noexcept {
        return custom ? custom->traversal_cost() : traversal;
    }

    /// The cost of a leaf of `count` primitives for a ray that meets it.
    [[nodiscard]] double leaf_cost(double count) const noexcept {
        return custom ? custom->leaf_cost(count) : intersection * count;
    }

    /// The expected cost of a split for a ray that meets the node, if both children were leaves.
    /// `p_below` and `p_above` are the children's surface areas divided by the node's.
    /// Source: [Tsiompikas2022] eq. 1, [Pharr2016] sec. 4.4.
    [[nodiscard]] double split_cost(double p_below, double count_below, double p_above,
                                    double count_above) const noexcept;
};

/// Throws Error(invalid_argument) naming the first constant outside its range.
COPPICE_EXPORT void require_valid(const SahCostModel& model);

}  // namespace coppice::inline v0
