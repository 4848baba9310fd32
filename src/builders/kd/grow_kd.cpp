// Refines the refilled tree. All primitives descend it once more, and each leaf is replaced by a
// k-d tree of its primitives. On the way, two kinds of planes that the sample chose badly are
// retracted. If kept, they cost more than all other effects of sampling (docs/decisions/0002).
//
// - A plane that cut off a cell which is empty in the sample but holds primitives was chosen for an
//   empty bonus that it does not earn. It is moved outward to where the cell is truly empty, if the
//   heuristic finds that cheaper with all primitives counted. If there is no such place, the plane
//   is removed, unless it saves a fifth of what the bonus promised.
// - A node whose plane was chosen from a handful of sampled primitives is rebuilt from all its
//   primitives.
//
// Planes that are kept are passed many levels at once (KdTopTree), down to the nodes where
// something must be decided. Each of these subtrees is a task, the largest first.
//
// Cost: two copies of a PrimRef for ten levels, then the builder's cost.

#include "coppice/base/parallel.h"
#include "coppice/builders/refine.h"

#include "base/free_memory.h"
#include "builders/chunk_sizes.h"
#include "builders/kd/kd_builder.h"
#include "builders/kd/partition.h"
#include "builders/kd/top_tree.h"
#include "builders/split/evaluate_plane.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace coppice::inline v0 {
namespace {

// A plane chosen from fewer sampled primitives is noise. A greater value leaves less of the tree to
// the sample, a smaller one makes the tree worse: docs/decisions/0002 has the measurements.
constexpr double min_sampled_primitives = 64.0;

// The end of the empty space at one side of a node: the first position that its PrimRefs reach from
// there.
float begin_of(std::span<const PrimRef> prim_refs, Axis axis, PlanarSide from) {
    float begin = from == PlanarSide::below ? Aabb::infinity : -Aabb::infinity;
    for (const PrimRef& prim_ref : prim_refs) {
        begin = from == PlanarSide::below ? std::min(begin, prim_ref.box.lower[axis])
                                          : std::max(begin, prim_ref.box.upper[axis]);
    }
    return begin;
}

class Grower {
public:
    Grower(const KdTree& tree, PrimitiveSetView primitives, const KdOptions& options,
           MemoryMeter* meter)
        : nodes_(tree.nodes()),
          references_below_(count_references(tree.nodes())),
          division_{primitives, options.split.clipping, meter},
          options_(options),
          builder_(primitives, options, until_it_pays(options.split), meter) {}

    // A node of the old tree with all its PrimRefs, box, depth and share of the work.
    struct Node {
        std::uint32_t index;
        std::vector<PrimRef> prim_refs;
        Aabb box;
        int depth;
        WorkShare work;
    };

    [[nodiscard]] TreePart grow(Node node) const {
        throw_if_cancelled();
        const KdNode& old = nodes_[node.index];
        if (old.is_leaf() || is_noise(node.prim_refs.size())) {
            return builder_.build(std::move(node.prim_refs), {.box = node.box, .depth = node.depth},
                                  node.work);
        }
        if (is_falsely_empty(old.lower_child())) return revise(std::move(node), PlanarSide::below);
        if (is_falsely_empty(old.upper_child())) return revise(std::move(node), PlanarSide::above);
        return split(std::move(node));
    }

private:
    // The number of references below each node. Children follow their parents, so one backward pass
    // suffices.
    static std::vector<std::uint64_t> count_references(std::span<const KdNode> nodes) {
        std::vector<std::uint64_t> counts(nodes.size());
        for (std::size_t i = nodes.size(); i-- > 0;) {
            const KdNode& node = nodes[i];
            counts[i] = node.is_leaf() ? node.reference_count()
                                       : counts[node.lower_child()] + counts[node.upper_child()];
        }
        return counts;
    }

    [[nodiscard]] bool is_noise(std::uint64_t prim_ref_count) const {
        const double rate = options_.sample.rate;
        return rate < 1.0 && static_cast<double>(prim_ref_count) * rate < min_sampled_primitives;
    }

    // True for inner nodes whose plane is retracted or may be.
    [[nodiscard]] bool is_open(std::uint32_t index) const {
        const KdNode& node = nodes_[index];
        return is_noise(references_below_[index]) || is_falsely_empty(node.lower_child()) ||
               is_falsely_empty(node.upper_child());
    }

    [[nodiscard]] bool is_falsely_empty(std::uint32_t child) const {
        const KdNode& node = nodes_[child];
        return node.is_leaf() && node.in_sample() == SampleContent::none &&
               node.reference_count() > 0;
    }

    // True if a split saves at least a fifth of what the empty bonus promised.
    [[nodiscard]] bool keeps_its_promise(double cost, std::size_t prim_ref_count) const {
        // The empty bonus of a custom model is unknown; 0 is used.
        const double bonus = options_.cost.custom ? 0.0 : options_.cost.empty_bonus;
        return cost <
               (1.0 - 0.2 * bonus) * options_.cost.leaf_cost(static_cast<double>(prim_ref_count));
    }

    // Decides about a plane whose child on `side` is empty in the sample but holds primitives.
    [[nodiscard]] TreePart revise(Node node, PlanarSide side) const {
        const KdNode& old = nodes_[node.index];
        const SplitPlane plane{old.axis(), begin_of(node.prim_refs, old.axis(), side)};
        const std::uint32_t rest =
            side == PlanarSide::below ? old.upper_child() : old.lower_child();
        const SplitQuery query{node.prim_refs, node.box, options_.cost, 0.0};
        const double old_cost = evaluate_plane(query, old.plane()).cost;
        if (!PlaneEvaluator(node.box, plane.axis, options_.cost).is_inside(plane.position)) {
            if (keeps_its_promise(old_cost, node.prim_refs.size())) return split(std::move(node));
            return grow({rest, std::move(node.prim_refs), node.box, node.depth, node.work});
        }
        if (!(evaluate_plane(query, plane).cost < old_cost)) return split(std::move(node));
        const bool is_empty_below = side == PlanarSide::below;
        TreePart grown = grow({rest, std::move(node.prim_refs),
                               is_empty_below ? above(node.box, plane) : below(node.box, plane),
                               node.depth + 1, node.work});
        return is_empty_below ? TreePart(plane, PlanarSide::above, TreePart(), std::move(grown))
                              : TreePart(plane, PlanarSide::below, std::move(grown), TreePart());
    }

    // Splits at the old tree's plane.
    [[nodiscard]] TreePart split(Node node) const {
        if (node.prim_refs.size() >= parallel_prim_ref_count) return split_on(std::move(node));
        const KdNode& old = nodes_[node.index];
        const SplitPlane plane = old.plane();
        MeteredBytes bytes(division_.meter, node.prim_refs);
        Partition sides = partition(node.prim_refs, plane, old.planar_side(), division_);
        const std::size_t prim_ref_count = node.prim_refs.size();
        free_memory(node.prim_refs);  // freed before the recursion, which needs the memory
        bytes.release();
        const int depth = node.depth + 1;
        const auto [work_below, work_above] =
            node.work.divide(prim_ref_count, sides.below.size(), sides.above.size());
        return build_both(
            plane, old.planar_side(), prim_ref_count,
            [&, work = work_below] {
                return grow(
                    {old.lower_child(), sides.take_below(), below(node.box, plane), depth, work});
            },
            [&, work = work_above] {
                return grow(
                    {old.upper_child(), sides.take_above(), above(node.box, plane), depth, work});
            });
    }

    // Splits at the old tree's planes many levels at once, down to the nodes where something must
    // be decided.
    [[nodiscard]] TreePart split_on(Node node) const {
        const KdTopTree top_tree(
            nodes_, {node.index, node.box, node.depth}, levels_at_once,
            [&](std::uint32_t index) { return index != node.index && is_open(index); });
        auto of_cells = top_tree.distribute(std::move(node.prim_refs), division_);
        std::vector<MeteredBytes> bytes;
        std::vector<std::size_t> order;
        for (std::size_t cell = 0; cell < of_cells.size(); ++cell) {
            bytes.emplace_back(division_.meter, of_cells[cell]);
            order.push_back(cell);
        }
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return of_cells[a].size() > of_cells[b].size();
        });
        const double count = count_of(of_cells);
        std::vector<TreePart> parts(of_cells.size());
        parallel_for_chunks(order.size(), 1, [&](std::size_t at, std::size_t /*end*/) {
            const std::size_t cell = order[at];
            const KdTopTree::Cell& root = top_tree.cells()[cell];
            bytes[cell].release();
            const double part = static_cast<double>(of_cells[cell].size()) / count;
            parts[cell] = grow({root.index, std::move(of_cells[cell]), root.box, root.depth,
                                node.work.part(part)});
        });
        return joined(top_tree, 0, parts);
    }

    static double count_of(std::span<const std::vector<PrimRef>> of_cells) {
        std::size_t count = 0;
        for (const std::vector<PrimRef>& prim_refs : of_cells) {
            count += prim_refs.size();
        }
        return static_cast<double>(std::max<std::size_t>(count, 1));
    }

    // Joins the parts of all cells below a node of the top tree.
    static TreePart joined(const TopTree& top_tree, std::uint32_t index,
                           std::vector<TreePart>& parts) {
        const TopTree::Node& node = top_tree.nodes()[index];
        if (node.is_cell) return std::move(parts[node.index]);
        TreePart lower = joined(top_tree, node.index, parts);
        TreePart upper = joined(top_tree, node.index + 1, parts);
        return {node.plane, node.planar_side, std::move(lower), std::move(upper)};
    }

    std::span<const KdNode> nodes_;
    std::vector<std::uint64_t> references_below_;
    Division division_;
    const KdOptions& options_;
    KdBuilder builder_;
};

}  // namespace

KdTree grow_kd(KdTree&& tree, PrimitiveSetView primitives, const KdOptions& options,
               const BuildContext& context) {
    Subtree grown = assemble(
        Grower(tree, primitives, options, context.memory)
            .grow({0, whole_prim_refs(primitives), tree.bounds(), 0, WorkShare(context.progress)}),
        context.memory);
    const Aabb box = tree.bounds();
    tree = KdTree{};
    return {std::move(grown.nodes), std::move(grown.references), box};
}

}  // namespace coppice::inline v0
