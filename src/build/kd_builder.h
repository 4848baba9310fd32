#pragma once

#include "coppice/build/build_options.h"
#include "coppice/build/progress.h"
#include "coppice/build/split_finder.h"
#include "coppice/geom/primitive_set.h"

#include "build/fragment_stack.h"
#include "build/partition.h"
#include "build/stop_rule.h"
#include "build/tree_part.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace coppice {

/// Builds k-d (sub)trees top-down by one split rule: what building on the sample and growing the
/// leaves share. Subtrees above a fixed size are built in parallel; the result does not depend on
/// the number of threads.
class KdBuilder {
public:
    /// Throws Error(invalid_argument) like choose_isa().
    KdBuilder(PrimitiveSetView primitives, const BuildOptions& options, const StopRule& stop,
              MemoryMeter* meter = nullptr, Progress* progress = nullptr);

    /// The subtree of a node with these fragments; `node.share` of the stage is done then.
    [[nodiscard]] TreePart build(std::vector<Fragment> fragments, NodeState node) const;

private:
    [[nodiscard]] std::optional<Split> find_split(std::span<const Fragment> fragments,
                                                  NodeState& node) const;
    void build_alone(Subtree& tree, std::uint32_t slot, FragmentStack& stack, std::size_t count,
                     NodeState node) const;

    Division division_;
    Division small_division_;  // of nodes where clipping takes more time than it saves
    const SplitFinder& finder_;
    SahCostModel cost_;
    StopRule stop_;
    Progress* progress_;
    Isa isa_;
};

}  // namespace coppice
