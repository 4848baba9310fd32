#pragma once

#include "coppice/build/build_options.h"
#include "coppice/geom/primitive_set.h"

#include "build/exact/exact_node.h"
#include "build/kd_builder.h"
#include "build/stop_rule.h"
#include "build/tree_part.h"

#include <vector>

namespace coppice {

/// Builds the tree that KdBuilder builds by the rule `exact`, plane for plane, in O(N log N).
class ExactBuilder {
public:
    /// options.split.rule must be "exact".
    ExactBuilder(PrimitiveSetView primitives, const BuildOptions& options, const StopRule& stop,
                 MemoryMeter* meter = nullptr, Progress* progress = nullptr);

    /// The subtree of a node with these fragments. Throws Error(limit) for 2^30 of them or more.
    [[nodiscard]] TreePart build(std::vector<Fragment> fragments, const NodeState& node) const;

private:
    [[nodiscard]] TreePart build_node(ExactNode node, NodeState state) const;

    Division division_;
    SahCostModel cost_;
    StopRule stop_;
    Progress* progress_;
    KdBuilder small_;  // for nodes where vectors are faster than lists
};

}  // namespace coppice
