// All primitives descend the skeleton, ten levels at once (KdTopTree), or one level at a time if
// there are few. The builder's own divide() divides them at each plane. So leaves receive exactly
// what the builder would have given them, in order of ids. Cost: O(N depth), two copies of a
// PrimRef for ten levels.
// Source: [Tsiompikas2022] sec. 4.3.3 (one primitive at a time, by position).

#include "coppice/builders/refill.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"
#include "coppice/tree/walk.h"

#include "base/free_memory.h"
#include "builders/chunk_sizes.h"
#include "builders/kd/partition.h"
#include "builders/kd/top_tree.h"
#include "builders/kd/tree_part.h"
#include "builders/work_share.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

namespace coppice::inline v0 {
namespace {

class Refill {
public:
    Refill(std::vector<KdNode>& nodes, const Division& division)
        : nodes_(nodes), division_(division) {}

    // Fills all leaves below a node. Appends their references to `references` in depth-first order.
    // Leaves receive their counts here, and their first reference in place_references().
    void fill(std::uint32_t index, std::vector<PrimRef> prim_refs,
              std::vector<std::uint32_t>& references) {
        MeteredBytes bytes(division_.meter, prim_refs);
        const KdNode node = nodes_[index];
        if (node.is_leaf()) {
            fill_leaf(index, prim_refs, references);
            return;
        }
        if (prim_refs.size() >= parallel_prim_ref_count) {
            bytes.release();
            fill_cells(index, std::move(prim_refs), references);
            return;
        }
        Partition sides = partition(prim_refs, node.plane(), node.planar_side(), division_);
        free_memory(prim_refs);
        bytes.release();
        fill(node.lower_child(), sides.take_below(), references);
        fill(node.upper_child(), sides.take_above(), references);
    }

private:
    // fill() for many levels at once.
    void fill_cells(std::uint32_t index, std::vector<PrimRef> prim_refs,
                    std::vector<std::uint32_t>& references) {
        const KdTopTree top_tree(nodes_, {index, {}, 0}, levels_at_once,
                                 [](std::uint32_t) { return false; });
        auto of_cells = top_tree.distribute(std::move(prim_refs), division_);
        std::vector<std::vector<std::uint32_t>> parts(of_cells.size());
        std::vector<MeteredBytes> part_bytes(of_cells.size());
        parallel_for_chunks(of_cells.size(), 1, [&](std::size_t cell, std::size_t /*end*/) {
            fill(top_tree.cells()[cell].index, std::move(of_cells[cell]), parts[cell]);
            part_bytes[cell] = {division_.meter, parts[cell]};
        });
        for (std::size_t cell = 0; cell < parts.size(); ++cell) {
            references.insert(references.end(), parts[cell].begin(), parts[cell].end());
            free_memory(parts[cell]);
            part_bytes[cell].release();
        }
    }

    void fill_leaf(std::uint32_t index, std::span<const PrimRef> prim_refs,
                   std::vector<std::uint32_t>& references) {
        if (prim_refs.size() > KdNode::max_payload) {
            throw Error(ErrorCode::limit,
                        fmt::format("a leaf would have {} references; at most {} are possible",
                                    prim_refs.size(), KdNode::max_payload));
        }
        for (const PrimRef& prim_ref : prim_refs) {
            references.push_back(prim_ref.id);
        }
        nodes_[index] = KdNode::make_leaf(0, static_cast<std::uint32_t>(prim_refs.size()),
                                          nodes_[index].in_sample());
    }

    std::vector<KdNode>& nodes_;
    Division division_;
};

// Sets the range of every leaf, now that all counts are known.
void place_references(std::vector<KdNode>& nodes, std::uint64_t reference_count) {
    if (reference_count > std::numeric_limits<std::uint32_t>::max()) {
        throw Error(ErrorCode::limit,
                    fmt::format("the tree would have {} references; at most 2^32 - 1 are possible",
                                reference_count));
    }
    std::uint32_t first = 0;
    walk_below(nodes, {}, [&](const VisitedNode& at) {
        KdNode& node = nodes[at.index];
        if (!node.is_leaf()) return;
        // A leaf that is empty in the sample and in the scene needs no mark.
        const bool is_empty = node.reference_count() == 0;
        node = KdNode::make_leaf(first, node.reference_count(),
                                 is_empty ? SampleContent::some : node.in_sample());
        first += node.reference_count();
    });
}

}  // namespace

KdTree refill(Skeleton&& skeleton, PrimitiveSetView primitives, const KdOptions& options,
              const BuildContext& context) {
    const Aabb box = skeleton.bounds();
    std::vector<KdNode> nodes = std::move(skeleton).release_nodes();
    std::vector<std::uint32_t> references;
    Refill(nodes, {primitives, options.split.clipping, context.memory})
        .fill(0, whole_prim_refs(primitives), references);
    place_references(nodes, references.size());
    WorkShare(context.progress).done();
    return {std::move(nodes), std::move(references), box};
}

}  // namespace coppice::inline v0
