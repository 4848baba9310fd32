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

/// A part of an 8-wide tree, built by one task: its nodes and leaves with indices of their own, and
/// the parts below it.
struct Part {
    /// The triangles of a leaf: a range of the grown tree's ids. Its blocks follow those of the
    /// preceding leaf.
    struct Leaf {
        std::uint32_t begin;
        std::uint32_t count;
    };

    /// A child that is the root of another part.
    struct Link {
        std::uint32_t node;
        std::uint32_t slot;
        std::unique_ptr<Part> part;
    };

    /// Size and links of the part, for Placement (stitch.h).
    [[nodiscard]] std::size_t own_node_count() const noexcept { return nodes.size(); }

    [[nodiscard]] std::size_t own_item_count() const noexcept { return block_count; }

    [[nodiscard]] std::size_t link_count() const noexcept { return links.size(); }

    [[nodiscard]] Part& link(std::size_t at) const noexcept { return *links[at].part; }

    std::vector<Bvh8Node> nodes;
    std::vector<Leaf> leaves;
    std::vector<Link> links;
    std::uint32_t block_count = 0;
};

/// An 8-wide tree whose leaves refer to triangle ids: the result of grow_bvh8() and the input of
/// assemble().
struct GrownTree {
    Part root;
    Aabb bounds;
};

/// The size of a part and all parts below it, in bytes.
[[nodiscard]] std::uint64_t byte_count(const Part& part) noexcept;

/// Builds the 8-wide tree over the cells of a top tree. The top tree is collapsed into nodes of
/// eight children. Every cell is refined by binned object splits, and by spatial splits as long as
/// it has spare room. The buffers receive the leaves' ids.
/// Source: [Wald2007], [Stich2009], [Tessari2023].
[[nodiscard]] GrownTree grow_bvh8(const Cells& cells, TriangleMeshView mesh, const Kernels& kernels,
                                  Progress* progress = nullptr);

/// Assembles the parts in depth-first order and copies the triangles' corners into blocks. The tree
/// overwrites the PrimRefs in the buffers. Throws Error(limit) if there are more nodes or blocks
/// than a child can refer to.
[[nodiscard]] Bvh8 assemble(GrownTree&& grown, DoubleBuffer&& buffers, TriangleMeshView mesh,
                            const Kernels& kernels, MemoryMeter& meter);

}  // namespace coppice::inline v0::bvh8
