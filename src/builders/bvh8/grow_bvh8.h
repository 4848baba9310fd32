#pragma once

#include "coppice/builders/progress.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/tree/bvh8.h"

#include "builders/bvh8/cells.h"
#include "builders/bvh8/double_buffer.h"
#include "builders/bvh8/splitter.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace coppice::inline v0::bvh8 {

/// A piece of an 8-wide tree, built by one task: nodes and leaves with their own numbering, and the
/// pieces that hang below it.
struct Part {
    /// A leaf's triangles: a range of the grown tree's ids. Its blocks follow those of the leaf
    /// before.
    struct Leaf {
        std::uint32_t begin;
        std::uint32_t count;
    };

    /// The root of another part as a child.
    struct Link {
        std::uint32_t node;
        std::uint32_t slot;
        std::unique_ptr<Part> part;
    };

    /// See Placement.
    [[nodiscard]] std::size_t own_node_count() const noexcept { return nodes.size(); }

    [[nodiscard]] std::size_t own_item_count() const noexcept { return block_count; }

    [[nodiscard]] std::size_t link_count() const noexcept { return links.size(); }

    [[nodiscard]] Part& link(std::size_t at) const noexcept { return *links[at].part; }

    std::vector<Bvh8Node> nodes;
    std::vector<Leaf> leaves;
    std::vector<Link> links;
    std::uint32_t block_count = 0;
};

/// An 8-wide tree whose leaves name their triangles: what grow_bvh8() finds out and assemble()
/// writes down.
struct GrownTree {
    Part root;
    Aabb bounds;
};

/// Bytes of a part and all below it.
[[nodiscard]] std::uint64_t byte_count(const Part& part) noexcept;

/// Builds the 8-wide tree over cells that hang in a top: the top is collapsed into nodes of eight,
/// and every cell is built on by binned object splits, and by spatial splits while it has room to
/// spare. The buffers receives the leaves' ids.
/// Source: [Wald2007], [Stich2009], [Tessari2023].
[[nodiscard]] GrownTree grow_bvh8(const Cells& cells, TriangleMeshView mesh, const Kernels& kernels,
                                  Progress* progress = nullptr);

/// Puts the parts together in depth-first order and copies the triangles' corners into blocks. The
/// tree takes the place of the PrimRefs in the buffers. Throws Error(limit) if there are more nodes
/// or blocks than a child can name.
[[nodiscard]] Bvh8 assemble(GrownTree&& grown, DoubleBuffer&& buffers, TriangleMeshView mesh,
                            const Kernels& kernels, MemoryMeter& meter);

}  // namespace coppice::inline v0::bvh8
