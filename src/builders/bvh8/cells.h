#pragma once

#include "coppice/geom/triangle_mesh.h"
#include "coppice/tree/kd_tree.h"

#include "builders/bvh8/double_buffer.h"
#include "builders/bvh8/splitter.h"
#include "builders/kernels/bvh8_kernels.h"
#include "builders/top_tree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coppice::inline v0::bvh8 {

/// A TopTree by centroids: a PrimRef belongs below a plane if the sum of its lower and upper bound
/// on the axis is less than the plane's position.
struct ObjectTop {
    TopTree tree;
    Box8 centroids = Box8::make_empty();  ///< range of the sampled centroids
};

/// Builds a top tree over sampled PrimRefs, whose weights say how many primitives each stands for.
/// Splits until a cell is expected to hold at most `cell_size` primitives. Reorders the sample.
[[nodiscard]] ObjectTop build_object_top(std::span<PrimRef> sample, float cell_size,
                                         const Kernels& kernels);

/// Copies every PrimRef of `from` to its cell: `to` receives them cell by cell, in their order. If
/// `to` is longer than `from`, cells share the spare room in proportion to their sizes. Returns the
/// cells' ranges in buffer 1, without boxes.
[[nodiscard]] std::vector<Range> fill_cells(const ObjectTop& top, std::span<PrimRef> from,
                                            std::span<PrimRef> to);

/// The cells that a tree is grown from: a top tree, and the PrimRefs below each of its leaves. Must
/// be initialized with an existing DoubleBuffer. If the buffer was constructed in the initializer
/// and memory ran out, g++ 12 destroyed `top` twice.
struct Cells {
    TopTree top;
    DoubleBuffer buffers;
    std::vector<Range> ranges;  ///< range of each cell, in one of both buffers
};

/// Consecutive ranges of the given sizes in buffer 0. Throws Error(limit) if they add up to more
/// than 2^32 - 1 PrimRefs.
[[nodiscard]] std::vector<Range> make_ranges(std::span<const std::size_t> sizes);

/// Makes cells of the leaves of a k-d tree, with the boxes of all triangles clipped to them. Ranges
/// have no boxes yet.
[[nodiscard]] Cells make_cells(const Skeleton& skeleton, TriangleMeshView mesh, MemoryMeter& meter);

/// Computes the boxes and centroid bounds of the ranges.
void measure_cells(Cells& cells, const Kernels& kernels);

}  // namespace coppice::inline v0::bvh8
