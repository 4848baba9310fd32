// The refilled tree is built on: all primitives go down it once more, and where they come to a leaf
// a k-d tree of its own takes its place. On the way, two kinds of planes that the sample chose
// badly are retracted; kept, they cost more than all else that sampling does (docs/decisions/0002).
// - A plane that cut off a cell which was empty in the sample but is not in the scene: it was
// chosen
//   for a bonus it does not earn. It moves out to where the cell is truly empty, if the heuristic,
//   with all primitives counted, finds that cheaper; where there is no such place it goes, unless
//   it saves a good part of that without the bonus.
// - A plane chosen from a handful of sampled primitives: the node is built anew from all of its
// own. Cost: one pass over the fragments a level, then the builder's.

#include "coppice/build/refine.h"

#include "build/kd_builder.h"
#include "build/partition.h"
#include "build/split/evaluate_plane.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace coppice {
namespace {

// A plane chosen from fewer sampled primitives is noise. More of them leave less of the tree to the
// sample, fewer make it worse: docs/decisions/0002 has what was measured.
constexpr double min_sampled_primitives = 64.0;

// Where the fragments of a node begin, seen from one of its sides.
float begin_of(std::span<const Fragment> fragments, Axis axis, PlanarSide from) {
    float begin = from == PlanarSide::below ? Aabb::infinity : -Aabb::infinity;
    for (const Fragment& fragment : fragments) {
        begin = from == PlanarSide::below ? std::min(begin, fragment.box.lower[axis])
                                          : std::max(begin, fragment.box.upper[axis]);
    }
    return begin;
}

class Grower {
public:
    Grower(const KdTree& tree, PrimitiveSetView primitives, const BuildOptions& options,
           MemoryMeter* meter)
        : nodes_(tree.nodes()),
          primitives_(primitives),
          options_(options),
          builder_(primitives, options, {0, 1, options.split.max_depth, SplitSearch::until_it_pays},
                   meter),
          meter_(meter) {}

    // A node of the old tree with all its fragments.
    struct Node {
        std::uint32_t index;
        std::vector<Fragment> fragments;
        Aabb box;
        int depth;
        MeteredBytes bytes;  // of the fragments
    };

    void grow(Subtree& grown, std::uint32_t slot, Node node) const {
        const KdNode& old = nodes_[node.index];
        if (old.is_leaf() || is_noise(node)) {
            splice(grown, slot, build_anew(std::move(node)));
        } else if (is_falsely_empty(old.lower_child())) {
            revise(grown, slot, std::move(node), PlanarSide::below);
        } else if (is_falsely_empty(old.upper_child())) {
            revise(grown, slot, std::move(node), PlanarSide::above);
        } else {
            split(grown, slot, std::move(node));
        }
    }

private:
    [[nodiscard]] Subtree build_anew(Node node) const {
        node.bytes.release();  // from here on the builder's
        return builder_.build(std::move(node.fragments), node.box, node.depth);
    }

    [[nodiscard]] bool is_noise(const Node& node) const {
        const double rate = options_.sample.rate;
        return rate < 1.0 &&
               static_cast<double>(node.fragments.size()) * rate < min_sampled_primitives;
    }

    [[nodiscard]] bool is_falsely_empty(std::uint32_t child) const {
        const KdNode& node = nodes_[child];
        return node.is_leaf() && node.in_sample() == SampleContent::none &&
               node.reference_count() > 0;
    }

    // True if a split saves at least a fifth of what the bonus for empty space promises.
    [[nodiscard]] bool keeps_its_promise(double cost, std::size_t fragment_count) const {
        return cost < (1.0 - 0.2 * options_.cost.empty_bonus) *
                          options_.cost.leaf_cost(static_cast<double>(fragment_count));
    }

    // Decides anew about a plane whose child on `side` was empty in the sample only.
    void revise(Subtree& grown, std::uint32_t slot, Node node, PlanarSide side) const {
        const KdNode& old = nodes_[node.index];
        const Plane plane{old.axis(), begin_of(node.fragments, old.axis(), side)};
        const std::uint32_t rest =
            side == PlanarSide::below ? old.upper_child() : old.lower_child();
        const SplitQuery query{node.fragments, node.box, options_.cost, 0.0};
        const double old_cost = evaluate_plane(query, old.plane()).cost;
        if (!PlaneEvaluator(node.box, plane.axis, options_.cost).is_inside(plane.position)) {
            if (keeps_its_promise(old_cost, node.fragments.size())) {
                split(grown, slot, std::move(node));
            } else {
                grow(
                    grown, slot,
                    {rest, std::move(node.fragments), node.box, node.depth, std::move(node.bytes)});
            }
            return;
        }
        if (!(evaluate_plane(query, plane).cost < old_cost)) {
            split(grown, slot, std::move(node));
            return;
        }
        const bool is_empty_below = side == PlanarSide::below;
        const std::uint32_t lower =
            make_inner(grown, slot, plane, is_empty_below ? PlanarSide::above : PlanarSide::below);
        const Aabb rest_box = is_empty_below ? above(node.box, plane) : below(node.box, plane);
        grow(grown, is_empty_below ? lower + 1 : lower,
             {rest, std::move(node.fragments), rest_box, node.depth + 1, std::move(node.bytes)});
    }

    // Splits as the old tree does.
    void split(Subtree& grown, std::uint32_t slot, Node node) const {
        const KdNode& old = nodes_[node.index];
        Partition sides = partition(node.fragments, old.plane(), old.planar_side(), primitives_,
                                    options_.split.clipping);
        const std::size_t fragment_count = node.fragments.size();
        MeteredBytes below_bytes(meter_, sides.below);
        MeteredBytes above_bytes(meter_, sides.above);
        node.bytes.release();
        node.fragments = {};  // freed before the recursion, which needs the memory
        build_children(
            grown, make_inner(grown, slot, old.plane(), old.planar_side()), fragment_count,
            [&](Subtree& part, std::uint32_t lower) {
                grow(part, lower,
                     {old.lower_child(), std::move(sides.below), below(node.box, old.plane()),
                      node.depth + 1, std::move(below_bytes)});
            },
            [&](Subtree& part, std::uint32_t upper) {
                grow(part, upper,
                     {old.upper_child(), std::move(sides.above), above(node.box, old.plane()),
                      node.depth + 1, std::move(above_bytes)});
            },
            meter_);
    }

    std::span<const KdNode> nodes_;
    PrimitiveSetView primitives_;
    const BuildOptions& options_;
    KdBuilder builder_;
    MemoryMeter* meter_;
};

}  // namespace

KdTree grow_kd(KdTree&& tree, PrimitiveSetView primitives, const BuildOptions& options,
               MemoryMeter* meter) {
    Subtree grown;
    std::vector<Fragment> all = whole_fragments(primitives);
    MeteredBytes bytes(meter, all);
    Grower(tree, primitives, options, meter)
        .grow(grown, 0, {0, std::move(all), tree.bounds(), 0, std::move(bytes)});
    const Aabb box = tree.bounds();
    tree = KdTree{};
    return {std::move(grown.nodes), std::move(grown.references), box};
}

}  // namespace coppice
