#pragma once

#include "coppice/base/memory_meter.h"
#include "coppice/base/parallel.h"

#include "builders/kd/subtree.h"
#include "builders/stitch.h"

#include <cstddef>
#include <memory>
#include <utility>

namespace coppice::inline v0 {

/// A tree under construction whose pieces were built apart, by tasks: either one piece, or a plane
/// with a part on each side. assemble() puts them in KdTree's order, each copied once.
class TreePart {
public:
    /// An empty leaf.
    TreePart();
    TreePart(TreePart&& other) noexcept;
    TreePart& operator=(TreePart&& other) noexcept;
    ~TreePart();

    /// A part in one piece.
    explicit TreePart(Subtree&& piece, MemoryMeter* meter = nullptr);

    /// Both parts under an inner node.
    TreePart(SplitPlane plane, PlanarSide planar_side, TreePart&& lower, TreePart&& upper);

    /// See Placement: an inner node above two parts, or a piece.
    [[nodiscard]] std::size_t own_node_count() const noexcept;
    [[nodiscard]] std::size_t own_item_count() const noexcept;
    [[nodiscard]] std::size_t link_count() const noexcept;
    [[nodiscard]] TreePart& link(std::size_t side) const noexcept;

    /// Moves its own nodes and references to their place.
    void move_to(Subtree& whole, const PartPlace& place);

private:
    struct Joint;

    Subtree piece_;
    MeteredBytes bytes_;  // of the piece
    std::unique_ptr<Joint> joint_;
};

/// The whole in one piece. Takes the parts apart as it goes. Throws Error(limit).
[[nodiscard]] Subtree assemble(TreePart&& part, MemoryMeter* meter = nullptr);

/// Work on fewer PrimRefs than this is not worth a task of its own.
inline constexpr std::size_t parallel_prim_ref_count = 4096;

/// Builds the parts on both sides of a plane, with callables that return them, and joins them: one
/// after the other if there are few PrimRefs, else in parallel. The result is the same.
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
