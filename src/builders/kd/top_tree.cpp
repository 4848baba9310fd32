// All PrimRefs descend many levels at once. A PrimRef is followed to all cells that it reaches
// before the next one, so that it is copied twice rather than once per level: first to its chunk's
// list, which is sorted by cell, then to the cell. The descent uses branches, since meshes are
// coherent. Cost: O(N levels) comparisons, two copies a PrimRef.

#include "builders/kd/top_tree.h"

#include "coppice/base/parallel.h"

#include "base/free_memory.h"
#include "builders/chunk_sizes.h"

#include <algorithm>
#include <array>

namespace coppice::inline v0 {
namespace {

// The PrimRefs that a chunk sends to the cells.
struct Sent {
    std::vector<PrimRef> prim_refs;
    std::vector<std::uint32_t> cells;
    std::vector<std::uint32_t> ends;  // end of each cell's PrimRefs after sort_by_cell()
    MeteredBytes bytes;
};

class Distributor {
public:
    Distributor(const TopTree& top, const Division& division, Sent& sent)
        : top_(top), division_(division), sent_(sent) {}

    void send(std::uint32_t from, const PrimRef& prim_ref) const {
        const std::uint32_t end = top_.descend(from, [&](const TopTree::Node& node) {
            switch (relation_to(prim_ref.box, node.plane)) {
                case PlaneRelation::below:
                    return TopTree::Step::below;
                case PlaneRelation::above:
                    return TopTree::Step::above;
                case PlaneRelation::in_plane:
                    return node.planar_side == PlanarSide::above ? TopTree::Step::above
                                                                 : TopTree::Step::below;
                case PlaneRelation::across:
                    break;
            }
            return TopTree::Step::nowhere;
        });
        const TopTree::Node& node = top_.nodes()[end];
        if (!node.is_cell) {
            send_to_both(node, prim_ref);
            return;
        }
        sent_.prim_refs.push_back(prim_ref);
        sent_.cells.push_back(node.index);
    }

private:
    void send_to_both(const TopTree::Node& node, const PrimRef& prim_ref) const {
        std::array<PrimRef, 2> parts;
        const PartitionOutput begin{parts.data(), parts.data() + 1};
        const PartitionOutput end =
            divide(std::span(&prim_ref, 1), node.plane, node.planar_side, division_, begin);
        if (end.below != begin.below) send(node.index, parts[0]);
        if (end.above != begin.above) send(node.index + 1, parts[1]);
    }

    const TopTree& top_;
    const Division& division_;
    Sent& sent_;
};

// Sorts by cell and keeps the order within each cell.
void sort_by_cell(Sent& sent, std::size_t cell_count) {
    std::vector<std::uint32_t> next(cell_count + 1);
    for (const std::uint32_t cell : sent.cells) {
        ++next[cell + 1];
    }
    for (std::size_t cell = 0; cell < cell_count; ++cell) {
        next[cell + 1] += next[cell];
    }
    std::vector<PrimRef> sorted(sent.prim_refs.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        sorted[next[sent.cells[i]]++] = sent.prim_refs[i];
    }
    next.pop_back();
    sent.ends = std::move(next);
    sent.prim_refs = std::move(sorted);
    free_memory(sent.cells);
}

std::vector<PrimRef> gathered(std::span<const Sent> chunks, std::size_t cell) {
    const auto range_in = [cell](const Sent& chunk) {
        const std::size_t begin = cell == 0 ? 0 : chunk.ends[cell - 1];
        return std::span(chunk.prim_refs).subspan(begin, chunk.ends[cell] - begin);
    };
    std::size_t count = 0;
    for (const Sent& chunk : chunks) {
        count += range_in(chunk).size();
    }
    std::vector<PrimRef> prim_refs;
    prim_refs.reserve(count);
    for (const Sent& chunk : chunks) {
        const auto range = range_in(chunk);
        prim_refs.insert(prim_refs.end(), range.begin(), range.end());
    }
    return prim_refs;
}

}  // namespace

KdTopTree::KdTopTree(std::span<const KdNode> tree, const Cell& root, int level_count,
                     const std::function<bool(std::uint32_t)>& ends_at) {
    const std::function<void(std::uint32_t, const Cell&)> add = [&](std::uint32_t slot,
                                                                    const Cell& at) {
        const KdNode& node = tree[at.index];
        if (node.is_leaf() || at.depth - root.depth >= level_count || ends_at(at.index)) {
            cells_.push_back(at);
            return;
        }
        const SplitPlane plane = node.plane();
        const std::uint32_t lower = split(slot, plane, node.planar_side());
        add(lower, {node.lower_child(), below(at.box, plane), at.depth + 1});
        add(lower + 1, {node.upper_child(), above(at.box, plane), at.depth + 1});
    };
    add(0, root);
    number_cells();
}

std::vector<std::vector<PrimRef>> KdTopTree::distribute(std::vector<PrimRef> prim_refs,
                                                        const Division& division) const {
    // Chunks depend on the number of PrimRefs alone, and their lists need little memory.
    const std::size_t chunk_size = std::max(primitives_per_task, prim_refs.size() / 64 + 1);
    MeteredBytes bytes(division.meter, prim_refs);
    std::vector<Sent> chunks((prim_refs.size() + chunk_size - 1) / chunk_size);
    parallel_for_chunks(prim_refs.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        Sent& sent = chunks[begin / chunk_size];
        sent.prim_refs.reserve((end - begin) + (end - begin) / 16);
        sent.cells.reserve(sent.prim_refs.capacity());
        const Distributor sender(*this, division, sent);
        for (std::size_t i = begin; i < end; ++i) {
            sender.send(0, prim_refs[i]);
        }
        sort_by_cell(sent, cells_.size());
        sent.bytes = {division.meter, sent.prim_refs};
    });
    free_memory(prim_refs);
    bytes.release();
    std::vector<std::vector<PrimRef>> of_cells(cells_.size());
    std::vector<MeteredBytes> cell_bytes(cells_.size());
    parallel_for_chunks(cells_.size(), 1, [&](std::size_t cell, std::size_t /*end*/) {
        of_cells[cell] = gathered(chunks, cell);
        cell_bytes[cell] = {division.meter, of_cells[cell]};
    });
    return of_cells;
}

}  // namespace coppice::inline v0
