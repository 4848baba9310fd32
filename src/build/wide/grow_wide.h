#pragma once

#include "coppice/build/progress.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/tree/wide_bvh.h"

#include "build/wide/arena.h"
#include "build/wide/splitter.h"
#include "build/wide/top.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace coppice::wide {

/// A piece of a wide tree, built by one task: nodes and leaves with their own numbering, and the
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

    std::vector<WideNode> nodes;
    std::vector<Leaf> leaves;
    std::vector<Link> links;
    std::uint32_t block_count = 0;
};

/// A wide tree whose leaves name their triangles: what grow_wide() finds out and assemble() writes
/// down.
struct GrownTree {
    Part root;
    Aabb bounds;
};

/// Bytes of a part and all below it.
[[nodiscard]] std::uint64_t byte_count(const Part& part) noexcept;

/// Builds the wide tree over cells that hang in a top: the top is collapsed into nodes of eight,
/// and every cell is built on by binned object splits, and by spatial splits while it has room to
/// spare. The arena receives the leaves' ids.
/// Source: [Wald2007], [Stich2009], [Tessari2023].
[[nodiscard]] GrownTree grow_wide(const Cells& cells, TriangleMeshView mesh, const Kernels& kernels,
                                  Progress* progress = nullptr);

/// Puts the parts together in depth-first order and copies the triangles' corners into blocks. The
/// tree takes the place of the references in the arena. Throws Error(limit) if there are more nodes
/// or blocks than a child can name.
[[nodiscard]] WideBvh assemble(GrownTree&& grown, Arena&& arena, TriangleMeshView mesh,
                               const Kernels& kernels, MemoryMeter& meter);

}  // namespace coppice::wide
