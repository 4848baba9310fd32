// Cells by planes. A k-d tree over the sample is the top tree, and its leaves are the cells. All
// triangles are distributed to them. A triangle that a plane cuts is in both cells, each with the
// part of its box in that cell, so that cells do not overlap. This is nearly what spatial splits
// give, for one pass over the triangles. Cost: that of KdTopTree::distribute().
// Source: [Stich2009] (PrimRefs cut by planes above an object hierarchy).

#include "coppice/base/parallel.h"

#include "base/free_memory.h"
#include "builders/bvh8/cells.h"
#include "builders/bvh8/make_prim_refs.h"
#include "builders/kd/subtree.h"
#include "builders/kd/top_tree.h"

namespace coppice::inline v0::bvh8 {

std::vector<Range> make_ranges(std::span<const std::size_t> sizes) {
    std::vector<Range> ranges;
    std::uint64_t count = 0;
    for (const std::size_t size : sizes) {
        const std::uint64_t begin = count;
        require_possible(0, count += size);
        ranges.push_back({.begin = static_cast<std::uint32_t>(begin),
                          .end = static_cast<std::uint32_t>(count),
                          .buffer = 0});
    }
    return ranges;
}

Cells make_cells(const Skeleton& skeleton, TriangleMeshView mesh, MemoryMeter& meter) {
    constexpr int all_levels = 64;
    const KdTopTree top_tree(skeleton.nodes(), {0, skeleton.bounds(), 0}, all_levels,
                             [](std::uint32_t) { return false; });
    auto of_cells = top_tree.distribute(whole_prim_refs(mesh), {mesh, Clipping::perfect, &meter});
    std::vector<MeteredBytes> bytes;
    std::vector<std::size_t> sizes;
    for (const std::vector<coppice::PrimRef>& prim_refs : of_cells) {
        bytes.emplace_back(&meter, prim_refs);
        sizes.push_back(prim_refs.size());
    }
    std::vector<Range> ranges = make_ranges(sizes);
    DoubleBuffer buffers(ranges.empty() ? 0 : ranges.back().end, meter);
    Cells made{top_tree, std::move(buffers), std::move(ranges)};
    const std::span<PrimRef> prim_refs = made.buffers.first();
    parallel_for_chunks(of_cells.size(), 1, [&](std::size_t cell, std::size_t /*end*/) {
        std::size_t at = made.ranges[cell].begin;
        for (const coppice::PrimRef& prim_ref : of_cells[cell]) {
            prim_refs[at++] = make_prim_ref(prim_ref.box, prim_ref.id);
        }
        free_memory(of_cells[cell]);
        bytes[cell].release();
    });
    return made;
}

}  // namespace coppice::inline v0::bvh8
