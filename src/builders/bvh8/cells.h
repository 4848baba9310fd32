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

/// A TopTree by centroids: a PrimRef goes below a plane if the sum of its bounds on the axis is
/// less than the plane's position.
struct ObjectTop {
    TopTree tree;
    Box8 centroids = Box8::make_empty();  ///< the range of those it was chosen from
};

/// A top over sampled PrimRefs, whose weights say how many primitives each stands for: split
/// until a cell is expected to hold at most `cell_size` primitives. Reorders the sample.
[[nodiscard]] ObjectTop build_object_top(std::span<PrimRef> sample, float cell_size,
                                         const Kernels& kernels);

/// Sends every PrimRef of `from` to the cell it belongs to: `to` receives them cell by cell, in
/// their order. If it is longer than `from`, cells share what is to spare by their sizes. Returns
/// the cells' ranges in buffer 1, without boxes.
[[nodiscard]] std::vector<Range> fill_cells(const ObjectTop& top, std::span<PrimRef> from,
                                            std::span<PrimRef> to);

/// The cells that a tree is grown from: a top, and the PrimRefs below each of its leaves. To be
/// initialized with an buffers that there is: where one was made in place and memory ran out, g++
/// 12 destroyed `top` twice.
struct Cells {
    TopTree top;
    DoubleBuffer buffers;
    std::vector<Range> ranges;  ///< of each cell, in one of the buffers's buffers
};

/// Ranges of those sizes, one behind the other in buffer 0. Throws Error(limit) if they pass 2^32
/// PrimRefs together.
[[nodiscard]] std::vector<Range> make_ranges(std::span<const std::size_t> sizes);

/// The leaves of a k-d tree as cells, the boxes of all triangles clipped to them. Ranges have no
/// boxes yet.
[[nodiscard]] Cells make_cells(const Skeleton& skeleton, TriangleMeshView mesh, MemoryMeter& meter);

/// Finds the boxes and centroids of the ranges.
void measure_cells(Cells& cells, const Kernels& kernels);

}  // namespace coppice::inline v0::bvh8
