// Sorts the events of all primitives once, then goes down: at each node one sweep over the sorted
// events finds the plane, and the children's events are filtered from their parent's, so that they
// need no sorting. Small nodes are left to KdBuilder, whose vectors search them by the same rule.
// Cost: O(N log N); 80 bytes a fragment, of a node and its children at the same time.
// Source: [WaldHavran2006] sec. 4.3.

#include "build/exact/exact_builder.h"

#include "build/exact/classify.h"
#include "build/exact/splice.h"
#include "build/exact/sweep.h"
#include "build/split/small_node.h"

#include <utility>

namespace coppice {

ExactBuilder::ExactBuilder(PrimitiveSetView primitives, const BuildOptions& options,
                           const StopRule& stop, MemoryMeter* meter)
    : division_{primitives, options.split.clipping, meter},
      cost_(options.cost),
      stop_(stop),
      small_(primitives, options, stop, meter) {}

TreePart ExactBuilder::build(std::vector<Fragment> fragments, const NodeState& node) const {
    return build_node(make_exact_node(std::move(fragments)), node);
}

TreePart ExactBuilder::build_node(ExactNode node, NodeState state) const {
    MeteredBytes bytes(division_.meter, node.capacity_bytes());
    const std::size_t count = node.fragments.size();
    if (count <= small_node_size) return small_.build(std::move(node.fragments), state);
    const double weight = weight_of(node.fragments);
    const double leaf_cost = cost_.leaf_cost(weight);
    std::optional<Split> split;
    if (!stop_.ends_at(state, weight, cost_)) split = sweep(node, state.box, weight, cost_);
    if (!split || !stop_.accepts(split->cost, leaf_cost, state)) {
        Subtree leaf;
        make_leaf(leaf, 0, node.fragments);
        return TreePart(std::move(leaf), division_.meter);
    }
    const Plane plane = split->plane;
    ExactChildren children;
    {
        Partition sides;
        const Classification classification =
            classify(node, plane, split->planar_side, division_, sides);
        children = splice(std::move(node), classification, std::move(sides));
    }
    // While the children's arrays were made, the node's were there too.
    MeteredBytes below_bytes(division_.meter, children.below.capacity_bytes());
    MeteredBytes above_bytes(division_.meter, children.above.capacity_bytes());
    bytes.release();
    const double more =
        static_cast<double>(children.below.fragments.size() + children.above.fragments.size()) /
        static_cast<double>(count);
    return build_both(
        plane, split->planar_side, count,
        [&] {
            below_bytes.release();  // the child counts its own
            return build_node(std::move(children.below),
                              state.child(below(state.box, plane), more));
        },
        [&] {
            above_bytes.release();
            return build_node(std::move(children.above),
                              state.child(above(state.box, plane), more));
        });
}

}  // namespace coppice
