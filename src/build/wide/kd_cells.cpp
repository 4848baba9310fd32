// Cells by planes: a k-d tree over the sample is the top, and its leaves are the cells. All
// triangles go down it at once. One that a plane cuts is in both cells with the part of its box
// that it has there, so that cells do not overlap: nearly what spatial splits give, for a pass over
// the triangles. Cost: that of Horizon::distribute(). Source: [Stich2009] (references cut by planes
// above an object hierarchy).

#include "coppice/base/parallel.h"

#include "base/free_memory.h"
#include "build/horizon.h"
#include "build/subtree.h"
#include "build/wide/make_references.h"
#include "build/wide/top.h"

namespace coppice::wide {

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
    const Horizon horizon(skeleton.nodes(), {0, skeleton.bounds(), 0}, all_levels,
                          [](std::uint32_t) { return false; });
    auto of_cells = horizon.distribute(whole_fragments(mesh), {mesh, Clipping::perfect, &meter});
    std::vector<MeteredBytes> bytes;
    std::vector<std::size_t> sizes;
    for (const std::vector<Fragment>& fragments : of_cells) {
        bytes.emplace_back(&meter, fragments);
        sizes.push_back(fragments.size());
    }
    std::vector<Range> ranges = make_ranges(sizes);
    Arena arena(ranges.empty() ? 0 : ranges.back().end, meter);
    Cells made{{}, std::move(arena), std::move(ranges)};
    made.top.nodes.clear();
    for (const Horizon::Node& node : horizon.nodes()) {
        const bool is_cell = node.lower == Horizon::Node::is_cell;
        made.top.nodes.push_back(is_cell ? TopNode{TopNode::is_cell, 0.0F, node.cell}
                                         : TopNode{static_cast<std::uint32_t>(node.plane.axis),
                                                   node.plane.position, node.lower});
    }
    made.top.cell_count = static_cast<std::uint32_t>(of_cells.size());
    const std::span<Reference> references = made.arena.first();
    parallel_for_chunks(of_cells.size(), 1, [&](std::size_t cell, std::size_t /*end*/) {
        std::size_t at = made.ranges[cell].begin;
        for (const Fragment& fragment : of_cells[cell]) {
            references[at++] = make_reference(fragment.box, fragment.id);
        }
        free_memory(of_cells[cell]);
        bytes[cell].release();
    });
    return made;
}

}  // namespace coppice::wide
