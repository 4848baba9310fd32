#pragma once

#include "coppice/builders/kd_options.h"
#include "coppice/geom/primitive_set.h"

#include "builders/kd/exact/exact_node.h"
#include "builders/kd/kd_builder.h"
#include "builders/kd/termination_rule.h"
#include "builders/kd/tree_part.h"

#include <vector>

namespace coppice::inline v0 {

/// Builds the same tree as KdBuilder with a rule that finds_cheapest_end(), plane for plane, in O(N
/// log N).
class ExactBuilder {
public:
    /// The options' rule must satisfy finds_cheapest_end().
    ExactBuilder(PrimitiveSetView primitives, const KdOptions& options, const TerminationRule& stop,
                 MemoryMeter* meter = nullptr);

    /// The subtree of a node with these PrimRefs. Throws Error(limit) for 2^30 of them or more.
    [[nodiscard]] TreePart build(std::vector<PrimRef> prim_refs, const NodeState& node,
                                 WorkShare work = {}) const;

private:
    [[nodiscard]] TreePart build_node(ExactNode node, NodeState state, WorkShare work) const;

    Division division_;
    SahCostModel cost_;
    TerminationRule stop_;
    KdBuilder small_;  // for small nodes, where its kernels are faster
};

}  // namespace coppice::inline v0
