// The parts of an 8-wide tree become its two arrays: first every part's place is found, depth
// first, then all are copied at the same time, and the triangles' corners fetched from the mesh.

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"

#include "builders/bvh8/grow_bvh8.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace coppice::inline v0::bvh8 {
namespace {

// A part and where its nodes and blocks begin in the tree's arrays.
struct PlacedPart {
    const Part* part;
    std::uint64_t first_node;
    std::uint64_t first_block;
    std::vector<std::uint64_t> link_nodes;  // where the roots of its links are
};

class Places {
public:
    void add(const Part& part) {
        const std::size_t at = parts.size();
        parts.push_back({&part, node_count, block_count, {}});
        node_count += part.nodes.size();
        block_count += part.block_count;
        for (const Part::Link& link : part.links) {
            parts[at].link_nodes.push_back(node_count);
            add(*link.part);
        }
    }

    std::vector<PlacedPart> parts;
    std::uint64_t node_count = 0;
    std::uint64_t block_count = 0;
};

Bvh8Child moved(Bvh8Child child, std::uint32_t first_node, std::uint32_t first_block) {
    if (child.is_empty()) return child;
    if (child.is_leaf()) {
        return Bvh8Child::make_leaf(first_block + child.first_block(), child.block_count());
    }
    return Bvh8Child::make_inner(first_node + child.node());
}

void copy_nodes(const PlacedPart& placed, std::span<Bvh8Node> nodes) {
    const auto first_node = static_cast<std::uint32_t>(placed.first_node);
    const auto first_block = static_cast<std::uint32_t>(placed.first_block);
    Bvh8Node* out = &nodes[placed.first_node];
    for (const Bvh8Node& node : placed.part->nodes) {
        *out = node;
        for (Bvh8Child& child : out->child) {
            child = moved(child, first_node, first_block);
        }
        ++out;
    }
    for (std::size_t at = 0; at < placed.part->links.size(); ++at) {
        const Part::Link& link = placed.part->links[at];
        nodes[placed.first_node + link.node].child[link.slot] =
            Bvh8Child::make_inner(static_cast<std::uint32_t>(placed.link_nodes[at]));
    }
}

void fill_blocks(const PlacedPart& placed, std::span<const std::uint32_t> ids,
                 const MeshArrays& mesh, const Kernels& kernels, std::span<TriangleBlock> blocks) {
    TriangleBlock* block = blocks.data() + placed.first_block;
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
    Places places;
    places.add(grown.root);
    if (places.node_count > Bvh8Child::max_node_index ||
        places.block_count > Bvh8Child::max_block_index) {
        throw Error(ErrorCode::limit,
                    fmt::format("the tree would have {} nodes and {} blocks of triangles; at most "
                                "{} and {} are possible",
                                places.node_count, places.block_count, Bvh8Child::max_node_index,
                                Bvh8Child::max_block_index));
    }
    const std::size_t node_bytes = places.node_count * sizeof(Bvh8Node);
    const std::size_t all_bytes = node_bytes + places.block_count * sizeof(TriangleBlock);
    const std::span<const std::uint32_t> ids = buffers.ids();
    const bool fits = all_bytes <= buffers.bytes_before_ids();
    BigBuffer storage = fits ? buffers.release() : BigBuffer(all_bytes);
    const MeteredBytes new_bytes(&meter, fits ? 0 : all_bytes);
    const auto nodes = storage.view<Bvh8Node>(0, places.node_count);
    const auto blocks = storage.view<TriangleBlock>(node_bytes, places.block_count);
    const MeshArrays arrays{mesh.vertices().data(), mesh.triangles().data()};
    parallel_for_chunks(places.parts.size(), 1, [&](std::size_t at, std::size_t /*end*/) {
        copy_nodes(places.parts[at], nodes);
        fill_blocks(places.parts[at], ids, arrays, kernels, blocks);
    });
    storage.shrink(all_bytes);
    return {std::make_shared<const BigBuffer>(std::move(storage)), nodes, blocks, grown.bounds};
}

}  // namespace coppice::inline v0::bvh8
