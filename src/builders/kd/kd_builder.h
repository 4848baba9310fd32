#pragma once

#include "coppice/builders/kd_options.h"
#include "coppice/builders/split_finder.h"
#include "coppice/geom/primitive_set.h"

#include "builders/kd/partition.h"
#include "builders/kd/prim_ref_stack.h"
#include "builders/kd/termination_rule.h"
#include "builders/kd/tree_part.h"
#include "builders/work_share.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// Builds k-d (sub)trees top-down by one split rule, both over the sample and in the leaves of the
/// refilled tree. Subtrees above a fixed size are built in parallel. The result does not depend on
/// the number of threads.
class KdBuilder {
public:
    /// Throws Error(invalid_argument) if COPPICE_ISA is invalid; see choose_isa().
    KdBuilder(PrimitiveSetView primitives, const KdOptions& options, const TerminationRule& stop,
              MemoryMeter* meter = nullptr);

    /// The subtree of a node with these PrimRefs. Reports its progress to `work`.
    [[nodiscard]] TreePart build(std::vector<PrimRef> prim_refs, NodeState node,
                                 WorkShare work = {}) const;

private:
    [[nodiscard]] std::optional<SplitCandidate> find_split(std::span<const PrimRef> prim_refs,
                                                           NodeState& node) const;
    void build_alone(Subtree& tree, std::uint32_t slot, PrimRefStack& stack, std::size_t count,
                     NodeState node) const;

    Division division_;
    Division small_division_;  // for small nodes, where clipping primitives does not pay
    const SplitFinder& finder_;
    SahCostModel cost_;
    TerminationRule stop_;
    Isa isa_;
};

}  // namespace coppice::inline v0
