// Cells by planes: a k-d tree over the sample, refilled with all triangles, is the top, and its leaves
// are the cells. A triangle that a plane cuts is in both cells with the part of its box that it has
// there, so that cells do not overlap: nearly what spatial splits give, for a pass over the
// triangles. Cost: the refill, and one clipped box a reference.
// Source: [Stich2009] (references cut by planes above an object hierarchy).

#include "coppice/base/parallel.h"
#include "coppice/tree/walk.h"

#include "build/wide/make_references.h"
#include "build/wide/top.h"

namespace coppice::wide {
namespace {

// The part of a triangle's box that lies in a cell. A triangle that only touches it may have none:
// then where the boxes touch.
Aabb box_in_cell(TriangleMeshView mesh, std::uint32_t id, const Aabb& cell) {
    const Aabb box = mesh.bounds(id);
    const Aabb common = intersection(box, cell);
    if (common == box || common.is_empty()) return box;
    const Aabb clipped = mesh.clipped_bounds(id, cell);
    return clipped.is_empty() ? common : clipped;
}

}  // namespace

Cells cells_of(const KdTree& tree, TriangleMeshView mesh, MemoryMeter& meter) {
    Cells made{{}, Arena(tree.references().size(), meter), {}};
    std::vector<Aabb> boxes;
    made.top.nodes.resize(tree.nodes().size());
    walk(tree, [&](const VisitedNode& at) {
        const KdNode& node = tree.nodes()[at.index];
        TopNode& top = made.top.nodes[at.index];
        if (!node.is_leaf()) {
            top = {static_cast<std::uint32_t>(node.axis()), node.position(), node.lower_child()};
            return;
        }
        top = {TopNode::is_cell, 0.0F, static_cast<std::uint32_t>(boxes.size())};
        const std::uint32_t begin = node.first_reference();
        made.ranges.push_back({.begin = begin, .end = begin + node.reference_count(), .buffer = 0});
        boxes.push_back(at.box);
    });
    made.top.cell_count = static_cast<std::uint32_t>(boxes.size());
    const std::span<Reference> references = made.arena.first();
    parallel_for_chunks(boxes.size(), 1, [&](std::size_t cell, std::size_t /*end*/) {
        for (std::uint32_t at = made.ranges[cell].begin; at < made.ranges[cell].end; ++at) {
            const std::uint32_t id = tree.references()[at];
            references[at] = make_reference(box_in_cell(mesh, id, boxes[cell]), id);
        }
    });
    return made;
}

}  // namespace coppice::wide
