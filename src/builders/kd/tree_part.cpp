#include "builders/kd/tree_part.h"

#include <algorithm>
#include <array>

namespace coppice::inline v0 {

struct TreePart::Joint {
    SplitPlane plane;
    PlanarSide planar_side;
    std::array<TreePart, 2> sides;  // below and above the plane
};

TreePart::TreePart() = default;
TreePart::TreePart(TreePart&& other) noexcept = default;
TreePart& TreePart::operator=(TreePart&& other) noexcept = default;
TreePart::~TreePart() = default;

TreePart::TreePart(Subtree&& piece, MemoryMeter* meter)
    : piece_(std::move(piece)), bytes_(meter, piece_.capacity_bytes()) {}

TreePart::TreePart(SplitPlane plane, PlanarSide planar_side, TreePart&& lower, TreePart&& upper)
    : joint_(std::make_unique<Joint>(
          Joint{plane, planar_side, {std::move(lower), std::move(upper)}})) {}

std::size_t TreePart::own_node_count() const noexcept {
    return joint_ ? 1 : piece_.nodes.size();
}

std::size_t TreePart::own_item_count() const noexcept {
    return joint_ ? 0 : piece_.references.size();
}

std::size_t TreePart::link_count() const noexcept {
    return joint_ ? joint_->sides.size() : 0;
}

TreePart& TreePart::link(std::size_t side) const noexcept {
    return joint_->sides[side];
}

void TreePart::move_to(Subtree& whole, const PartPlace& place) {
    const auto root = static_cast<std::size_t>(place.root);
    const auto below = static_cast<std::uint32_t>(place.below);
    if (joint_) {
        whole.nodes[root] = KdNode::make_inner(joint_->plane, joint_->planar_side, below);
        return;
    }
    // Node i >= 1 of the piece moves to index below + i - 1.
    const std::uint32_t node_offset = below - 1;
    const auto references = static_cast<std::uint32_t>(place.items);
    whole.nodes[root] = relocated(piece_.nodes[0], node_offset, references);
    for (std::size_t i = 1; i < piece_.nodes.size(); ++i) {
        whole.nodes[node_offset + i] = relocated(piece_.nodes[i], node_offset, references);
    }
    std::copy(piece_.references.begin(), piece_.references.end(),
              whole.references.begin() + references);
    piece_ = {};
    bytes_.release();
}

Subtree assemble(TreePart&& part, MemoryMeter* meter) {
    // A KdNode needs its children side by side.
    const Placement<TreePart, LinkedRoots::together> places(part);
    require_possible(places.node_count(), places.item_count());
    Subtree whole;
    whole.nodes.resize(places.node_count());
    whole.references.resize(places.item_count());
    const MeteredBytes bytes(meter, whole.capacity_bytes());
    places.for_each([&](const auto& placed) { placed.part->move_to(whole, placed.place); });
    return whole;
}

}  // namespace coppice::inline v0
