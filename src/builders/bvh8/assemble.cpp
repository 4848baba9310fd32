// Puts the parts of an 8-wide tree into its two arrays (stitch.h) and fetches the corners of
// triangles from the mesh.

#include "coppice/base/error.h"

#include "builders/bvh8/grow_bvh8.h"
#include "builders/stitch.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace coppice::inline v0::bvh8 {
namespace {

using Places = Placement<Part, LinkedRoots::apart>;

Bvh8Child moved(Bvh8Child child, std::uint32_t first_node, std::uint32_t first_block) {
    if (child.is_empty()) return child;
    if (child.is_leaf()) {
        return Bvh8Child::make_leaf(first_block + child.first_block(), child.block_count());
    }
    return Bvh8Child::make_inner(first_node + child.node());
}

void copy_nodes(const Places::Placed& placed, std::span<Bvh8Node> nodes) {
    const auto root = static_cast<std::uint32_t>(placed.place.root);
    const auto first_block = static_cast<std::uint32_t>(placed.place.items);
    Bvh8Node* out = &nodes[root];
    for (const Bvh8Node& node : placed.part->nodes) {
        *out = node;
        for (Bvh8Child& child : out->child) {
            child = moved(child, root, first_block);
        }
        ++out;
    }
    for (std::size_t at = 0; at < placed.part->links.size(); ++at) {
        const Part::Link& link = placed.part->links[at];
        nodes[root + link.node].child[link.slot] =
            Bvh8Child::make_inner(static_cast<std::uint32_t>(placed.link_roots[at]));
    }
}

void fill_blocks(const Places::Placed& placed, std::span<const std::uint32_t> ids,
                 const MeshArrays& mesh, const Kernels& kernels, std::span<TriangleBlock> blocks) {
    TriangleBlock* block = blocks.data() + placed.place.items;
    for (const Part::Leaf& leaf : placed.part->leaves) {
        auto rest = ids.subspan(leaf.begin, leaf.count);
        while (!rest.empty()) {
            const std::size_t count = std::min(rest.size(), bvh8_width);
            kernels.fill_block(rest.first(count), mesh, *block++);
            rest = rest.subspan(count);
        }
    }
}

}  // namespace

Bvh8 assemble(GrownTree&& grown, DoubleBuffer&& buffers, TriangleMeshView mesh,
              const Kernels& kernels, MemoryMeter& meter) {
    const Places places(grown.root);
    if (places.node_count() > Bvh8Child::max_node_index ||
        places.item_count() > Bvh8Child::max_block_index) {
        throw Error(ErrorCode::limit,
                    fmt::format("the tree would have {} nodes and {} blocks of triangles; at most "
                                "{} and {} are possible",
                                places.node_count(), places.item_count(), Bvh8Child::max_node_index,
                                Bvh8Child::max_block_index));
    }
    const std::size_t node_bytes = places.node_count() * sizeof(Bvh8Node);
    const std::size_t all_bytes = node_bytes + places.item_count() * sizeof(TriangleBlock);
    const std::span<const std::uint32_t> ids = buffers.ids();
    const bool fits = all_bytes <= buffers.bytes_before_ids();
    BigBuffer storage = fits ? buffers.release() : BigBuffer(all_bytes);
    const MeteredBytes new_bytes(&meter, fits ? 0 : all_bytes);
    const auto nodes = storage.view<Bvh8Node>(0, places.node_count());
    const auto blocks = storage.view<TriangleBlock>(node_bytes, places.item_count());
    const MeshArrays arrays{mesh.vertices().data(), mesh.triangles().data()};
    places.for_each([&](const Places::Placed& placed) {
        copy_nodes(placed, nodes);
        fill_blocks(placed, ids, arrays, kernels, blocks);
    });
    storage.shrink(all_bytes);
    return {std::make_shared<const BigBuffer>(std::move(storage)), nodes, blocks, grown.bounds};
}

}  // namespace coppice::inline v0::bvh8
