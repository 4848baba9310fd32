#include "builders/kd/kd_builder.h"

#include "coppice/base/parallel.h"

#include "base/free_memory.h"

#include <utility>

namespace coppice::inline v0 {
namespace {

double ratio(std::size_t after, std::size_t before) noexcept {
    return static_cast<double>(after) / static_cast<double>(before);
}

// In nodes of at most this many PrimRefs, if splits continue as long as they pay and the rule
// allows it, boxes are clipped instead of primitives. Half of all clipping happens there, and few
// of the following splits would gain by it (docs/decisions/0004).
constexpr std::size_t boxes_cut_up_to = 12;

Clipping clipping_in_small_nodes(const KdOptions& options, const TerminationRule& stop) {
    const bool is_quick = split_finder_of(options.split).allows_loose_small_nodes() &&
                          stop.search == SplitSearch::until_it_pays;
    return is_quick ? Clipping::bounding_box : options.split.clipping;
}

}  // namespace

KdBuilder::KdBuilder(PrimitiveSetView primitives, const KdOptions& options,
                     const TerminationRule& stop, MemoryMeter* meter)
    : division_{primitives, options.split.clipping, meter},
      small_division_{primitives, clipping_in_small_nodes(options, stop), meter},
      finder_(split_finder_of(options.split)),
      cost_(options.cost),
      stop_(stop),
      isa_(choose_isa()) {}

// The split of a node, or nothing if it becomes a leaf. Counts splits that do not pay in the node's
// state.
std::optional<SplitCandidate> KdBuilder::find_split(std::span<const PrimRef> prim_refs,
                                                    NodeState& node) const {
    const double weight = weight_of(prim_refs);
    if (stop_.ends_at(node, weight, cost_)) return std::nullopt;
    const double leaf_cost = cost_.leaf_cost(weight);
    const auto split =
        finder_.find({prim_refs, node.box, cost_, stop_.acceptable_cost(leaf_cost), isa_});
    if (!split || !stop_.accepts(split->cost, leaf_cost, node)) return std::nullopt;
    return split;
}

TreePart KdBuilder::build(std::vector<PrimRef> prim_refs, NodeState node, WorkShare work) const {
    throw_if_cancelled();
    MeteredBytes bytes(division_.meter, prim_refs);
    if (prim_refs.size() < parallel_prim_ref_count) {
        Subtree tree;
        const std::size_t count = prim_refs.size();
        PrimRefStack stack(std::move(prim_refs));
        build_alone(tree, 0, stack, count, node);
        work.done();
        return TreePart(std::move(tree), division_.meter);
    }
    const auto split = find_split(prim_refs, node);
    if (!split) {
        Subtree leaf;
        make_leaf(leaf, 0, prim_refs);
        work.done();
        return TreePart(std::move(leaf), division_.meter);
    }
    const SplitPlane plane = split->plane;
    const std::size_t count = prim_refs.size();
    Partition sides = partition(prim_refs, plane, split->planar_side, division_);
    free_memory(prim_refs);  // freed before the recursion, which needs the memory
    bytes.release();
    const double more = ratio(sides.below.size() + sides.above.size(), count);
    const auto [work_below, work_above] =
        work.divide(count, sides.below.size(), sides.above.size());
    const NodeState lower = node.child(below(node.box, plane), more);
    const NodeState upper = node.child(above(node.box, plane), more);
    return build_both(
        plane, split->planar_side, count,
        [&, work = work_below] { return build(sides.take_below(), lower, work); },
        [&, work = work_above] { return build(sides.take_above(), upper, work); });
}

// Builds a subtree within one task. The node's PrimRefs are the topmost `count` of the stack, and
// are popped.
void KdBuilder::build_alone(Subtree& tree, std::uint32_t slot, PrimRefStack& stack,
                            std::size_t count, NodeState node) const {
    const auto split = find_split(stack.top(count), node);
    if (!split) {
        make_leaf(tree, slot, stack.top(count));
        stack.pop(count);
        return;
    }
    const SplitPlane plane = split->plane;
    const Division& division = count <= boxes_cut_up_to ? small_division_ : division_;
    const auto sides = stack.divide_top(count, plane, split->planar_side, division);
    const std::uint32_t lower = make_inner(tree, slot, plane, split->planar_side);
    const double more = ratio(sides.below + sides.above, count);
    build_alone(tree, lower, stack, sides.below, node.child(below(node.box, plane), more));
    build_alone(tree, lower + 1, stack, sides.above, node.child(above(node.box, plane), more));
}

}  // namespace coppice::inline v0
