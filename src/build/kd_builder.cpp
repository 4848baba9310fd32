#include "build/kd_builder.h"

#include "build/partition.h"

#include <limits>
#include <utility>

namespace coppice {
KdBuilder::KdBuilder(PrimitiveSetView primitives, const BuildOptions& options, const StopRule& stop,
                     MemoryMeter* meter)
    : primitives_(primitives),
      finder_(find_split_finder(options.split.rule)),
      cost_(options.cost),
      clipping_(options.split.clipping),
      stop_(stop),
      meter_(meter) {}

Subtree KdBuilder::build(std::vector<Fragment> fragments, const Aabb& box, int depth) const {
    Subtree tree;
    MeteredBytes bytes(meter_, fragments);
    build_into(tree, 0, {std::move(fragments), box, depth, 0, std::move(bytes)});
    return tree;
}

// The split of a node, or nothing if it is to be a leaf; counts a bad refine on the node's path.
std::optional<Split> KdBuilder::find_split(Node& node) const {
    if (node.fragments.empty() || node.depth >= stop_.max_depth || node.box.surface_area() == 0.0) {
        return std::nullopt;
    }
    const double weight = weight_of(node.fragments);
    if (weight <= stop_.max_leaf) return std::nullopt;
    const double leaf_cost = cost_.leaf_cost(weight);
    const double acceptable_cost = stop_.search == SplitSearch::until_it_pays
                                       ? leaf_cost
                                       : std::numeric_limits<double>::infinity();
    const auto split = finder_.find({node.fragments, node.box, cost_, acceptable_cost});
    if (!split) return std::nullopt;
    if (!(split->cost < leaf_cost)) ++node.bad_refines_so_far;
    if (node.bad_refines_so_far >= stop_.bad_refines) return std::nullopt;
    return split;
}

void KdBuilder::build_into(Subtree& tree, std::uint32_t slot, Node node) const {
    const auto split = find_split(node);
    if (!split) {
        make_leaf(tree, slot, node.fragments);
        return;
    }
    Partition sides =
        partition(node.fragments, split->plane, split->planar_side, primitives_, clipping_);
    const std::size_t fragment_count = node.fragments.size();
    MeteredBytes below_bytes(meter_, sides.below);
    MeteredBytes above_bytes(meter_, sides.above);
    node.bytes.release();
    node.fragments = {};  // freed before the recursion, which needs the memory
    const auto build_child = [&](Subtree& part, std::uint32_t part_slot,
                                 std::vector<Fragment>& fragments, const Aabb& box,
                                 MeteredBytes& bytes) {
        build_into(
            part, part_slot,
            {std::move(fragments), box, node.depth + 1, node.bad_refines_so_far, std::move(bytes)});
    };
    build_children(
        tree, make_inner(tree, slot, split->plane, split->planar_side), fragment_count,
        [&](Subtree& part, std::uint32_t lower) {
            build_child(part, lower, sides.below, below(node.box, split->plane), below_bytes);
        },
        [&](Subtree& part, std::uint32_t upper) {
            build_child(part, upper, sides.above, above(node.box, split->plane), above_bytes);
        },
        meter_);
}

}  // namespace coppice
