#pragma once

#include "coppice/base/memory_meter.h"
#include "coppice/base/parallel.h"

#include "builders/kd/subtree.h"
#include "builders/stitch.h"

#include <cstddef>
#include <memory>
#include <utility>

namespace coppice::inline v0 {

/// A tree under construction whose pieces were built by separate tasks: either one piece, or a
/// plane with a part on each side. assemble() copies all pieces into KdTree's order, each once.
class TreePart {
public:
    /// An empty leaf.
    TreePart();
    TreePart(TreePart&& other) noexcept;
    TreePart& operator=(TreePart&& other) noexcept;
    ~TreePart();

    /// A part in one piece.
    explicit TreePart(Subtree&& piece, MemoryMeter* meter = nullptr);

    /// An inner node with a part on each side.
    TreePart(SplitPlane plane, PlanarSide planar_side, TreePart&& lower, TreePart&& upper);

    /// Sizes and links for Placement (stitch.h). A part is an inner node above two parts, or a
    /// piece.
    [[nodiscard]] std::size_t own_node_count() const noexcept;
    [[nodiscard]] std::size_t own_item_count() const noexcept;
    [[nodiscard]] std::size_t link_count() const noexcept;
    [[nodiscard]] TreePart& link(std::size_t side) const noexcept;

    /// Copies its own nodes and references to their place.
    void move_to(Subtree& whole, const PartPlace& place);

private:
    struct Joint;

    Subtree piece_;
    MeteredBytes bytes_;  // memory of the piece
    std::unique_ptr<Joint> joint_;
};

/// Assembles all parts into one piece. Frees the parts on the way. Throws Error(limit) if there are
/// too many nodes or references.
[[nodiscard]] Subtree assemble(TreePart&& part, MemoryMeter* meter = nullptr);

/// Nodes of fewer PrimRefs do not justify a task of their own.
inline constexpr std::size_t parallel_prim_ref_count = 4096;

/// Builds the parts on both sides of a plane with callables that return them, and joins them. In
/// parallel if there are many PrimRefs; the result is the same.
template <typename BuildLower, typename BuildUpper>
[[nodiscard]] TreePart build_both(SplitPlane plane, PlanarSide planar_side,
                                  std::size_t prim_ref_count, BuildLower&& build_lower,
                                  BuildUpper&& build_upper) {
    TreePart lower;
    TreePart upper;
    if (prim_ref_count < parallel_prim_ref_count) {
        lower = build_lower();
        upper = build_upper();
    } else {
        parallel_invoke([&] { lower = build_lower(); }, [&] { upper = build_upper(); });
    }
    return {plane, planar_side, std::move(lower), std::move(upper)};
}

}  // namespace coppice::inline v0
