#pragma once

#include "coppice/geom/aabb.h"

#include <cstdint>
#include <cstring>

namespace coppice::inline v0 {

/// The side of its plane on which a node keeps primitives that lie wholly in the plane. Recorded in
/// each node, because building and refilling must decide alike.
enum class PlanarSide : std::uint8_t { below = 0, above = 1 };

/// Whether a leaf held any primitive of the sample that its planes were chosen for.
enum class SampleContent : std::uint8_t { some = 0, none = 1 };

/// One node of a k-d tree, in 8 bytes. An inner node has a plane and the index of its lower child;
/// the upper child follows the lower one. A leaf has a range of references.
class KdNode {
public:
    /// The greatest number of references of a leaf, and the greatest index of a child.
    static constexpr std::uint32_t max_payload = (1U << 29) - 1;

    /// An empty leaf.
    constexpr KdNode() noexcept = default;

    /// A leaf of `count` references that starts at reference `first`; count <= max_payload.
    [[nodiscard]] static KdNode make_leaf(std::uint32_t first, std::uint32_t count,
                                          SampleContent in_sample = SampleContent::some) noexcept {
        return {first,
                count << tag_bits | static_cast<std::uint32_t>(in_sample) << flag_shift | leaf_tag};
    }

    /// An inner node whose children are nodes `lower_child` and `lower_child + 1`;
    /// lower_child <= max_payload.
    [[nodiscard]] static KdNode make_inner(SplitPlane plane, PlanarSide planar_side,
                                           std::uint32_t lower_child) noexcept {
        std::uint32_t position_bits = 0;
        std::memcpy(&position_bits, &plane.position, sizeof position_bits);
        return {position_bits, lower_child << tag_bits |
                                   static_cast<std::uint32_t>(planar_side) << flag_shift |
                                   static_cast<std::uint32_t>(plane.axis)};
    }

    /// True for a leaf, false for an inner node.
    [[nodiscard]] bool is_leaf() const noexcept { return (tagged_ & axis_mask) == leaf_tag; }

    /// The axis of the plane. Inner nodes only.
    [[nodiscard]] Axis axis() const noexcept { return static_cast<Axis>(tagged_ & axis_mask); }

    /// The position of the plane. Inner nodes only.
    [[nodiscard]] float position() const noexcept {
        float position = 0.0F;
        std::memcpy(&position, &payload_, sizeof position);
        return position;
    }

    /// The plane. Inner nodes only.
    [[nodiscard]] SplitPlane plane() const noexcept { return {axis(), position()}; }

    /// The side of primitives in the plane. Inner nodes only.
    [[nodiscard]] PlanarSide planar_side() const noexcept {
        return static_cast<PlanarSide>(tagged_ >> flag_shift & 1U);
    }

    /// The index of the child below the plane. Inner nodes only.
    [[nodiscard]] std::uint32_t lower_child() const noexcept { return tagged_ >> tag_bits; }

    /// The index of the child above the plane. Inner nodes only.
    [[nodiscard]] std::uint32_t upper_child() const noexcept { return lower_child() + 1; }

    /// The index of the first reference. Leaves only.
    [[nodiscard]] std::uint32_t first_reference() const noexcept { return payload_; }

    /// The number of references. Leaves only.
    [[nodiscard]] std::uint32_t reference_count() const noexcept { return tagged_ >> tag_bits; }

    /// Whether the leaf held any primitive of the sample. Leaves only. A leaf with `none` that has
    /// references is a cell that is empty in the sample but holds primitives.
    [[nodiscard]] SampleContent in_sample() const noexcept {
        return static_cast<SampleContent>(tagged_ >> flag_shift & 1U);
    }

    friend constexpr bool operator==(const KdNode&, const KdNode&) = default;

private:
    static constexpr std::uint32_t axis_mask = 3;
    static constexpr std::uint32_t leaf_tag = 3;
    static constexpr unsigned flag_shift = 2;
    static constexpr unsigned tag_bits = 3;

    constexpr KdNode(std::uint32_t payload, std::uint32_t tagged) noexcept
        : payload_(payload), tagged_(tagged) {}

    std::uint32_t payload_ = 0;        // plane position (float bits) or first reference
    std::uint32_t tagged_ = leaf_tag;  // 29 bits child or count, 1 planar side or sample content,
                                       // 2 axis or leaf
};

static_assert(sizeof(KdNode) == 8);

}  // namespace coppice::inline v0
