// Sorts the events of all primitives once, then descends. At each node, one sweep over the sorted
// events finds the plane. The children's events are filtered from their parent's, so that they need
// no sorting. Small nodes are left to KdBuilder, whose kernels find the same planes faster. Cost:
// O(N log N) time; 80 bytes a PrimRef, for a node and its children at the same time.
// Source: [WaldHavran2006] sec. 4.3.

#include "builders/kd/exact/exact_builder.h"

#include "coppice/base/parallel.h"

#include "builders/kd/exact/classify.h"
#include "builders/kd/exact/splice.h"
#include "builders/kd/exact/sweep.h"
#include "builders/split/small_node.h"

#include <utility>

namespace coppice::inline v0 {

ExactBuilder::ExactBuilder(PrimitiveSetView primitives, const KdOptions& options,
                           const TerminationRule& stop, MemoryMeter* meter)
    : division_{primitives, options.split.clipping, meter},
      cost_(options.cost),
      stop_(stop),
      small_(primitives, options, stop, meter) {}

TreePart ExactBuilder::build(std::vector<PrimRef> prim_refs, const NodeState& node,
                             WorkShare work) const {
    constexpr double part_of_sorting = 0.12;
    ExactNode root = make_exact_node(std::move(prim_refs));
    work.part(part_of_sorting).done();
    return build_node(std::move(root), node, work.part(1.0 - part_of_sorting));
}

TreePart ExactBuilder::build_node(ExactNode node, NodeState state, WorkShare work) const {
    const std::size_t count = node.prim_refs.size();
    if (count < parallel_prim_ref_count && work.is_asked_for()) {
        TreePart part = build_node(std::move(node), state, {});  // small: reported when done
        work.done();
        return part;
    }
    throw_if_cancelled();
    MeteredBytes bytes(division_.meter, node.capacity_bytes());
    if (count <= small_node_size) return small_.build(std::move(node.prim_refs), state);
    const double weight = weight_of(node.prim_refs);
    const double leaf_cost = cost_.leaf_cost(weight);
    std::optional<SplitCandidate> split;
    if (!stop_.ends_at(state, weight, cost_)) split = sweep(node, state.box, weight, cost_);
    if (!split || !stop_.accepts(split->cost, leaf_cost, state)) {
        Subtree leaf;
        make_leaf(leaf, 0, node.prim_refs);
        work.done();
        return TreePart(std::move(leaf), division_.meter);
    }
    const SplitPlane plane = split->plane;
    ExactChildren children;
    {
        Partition sides;
        const Classification classification =
            classify(node, plane, split->planar_side, division_, sides);
        children = splice(std::move(node), classification, std::move(sides));
    }
    // The node's arrays existed while the children's were made.
    MeteredBytes below_bytes(division_.meter, children.below.capacity_bytes());
    MeteredBytes above_bytes(division_.meter, children.above.capacity_bytes());
    bytes.release();
    const std::size_t below_count = children.below.prim_refs.size();
    const std::size_t above_count = children.above.prim_refs.size();
    const double more = static_cast<double>(below_count + above_count) / static_cast<double>(count);
    const auto [work_below, work_above] = work.divide(count, below_count, above_count);
    return build_both(
        plane, split->planar_side, count,
        [&, work = work_below] {
            below_bytes.release();  // the child counts its own memory
            return build_node(std::move(children.below), state.child(below(state.box, plane), more),
                              work);
        },
        [&, work = work_above] {
            above_bytes.release();
            return build_node(std::move(children.above), state.child(above(state.box, plane), more),
                              work);
        });
}

}  // namespace coppice::inline v0
