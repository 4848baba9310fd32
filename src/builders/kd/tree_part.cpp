// Tasks build their pieces of the tree in arrays of their own; where each goes in the whole is
// known only when all are done. Splicing pieces into their parents, level by level, would copy a
// node as often as it has tasks above it; here each is copied once, in parallel.

#include "builders/kd/tree_part.h"

#include <algorithm>

namespace coppice::inline v0 {

struct TreePart::Joint {
    SplitPlane plane;
    PlanarSide planar_side;
    TreePart lower;
    TreePart upper;
    std::uint64_t node_count;
    std::uint64_t reference_count;
};

TreePart::TreePart() = default;
TreePart::TreePart(TreePart&& other) noexcept = default;
TreePart& TreePart::operator=(TreePart&& other) noexcept = default;
TreePart::~TreePart() = default;

TreePart::TreePart(Subtree&& piece, MemoryMeter* meter)
    : piece_(std::move(piece)), bytes_(meter, piece_.capacity_bytes()) {}

TreePart::TreePart(SplitPlane plane, PlanarSide planar_side, TreePart&& lower, TreePart&& upper)
    : joint_(std::make_unique<Joint>(
          Joint{plane, planar_side, std::move(lower), std::move(upper), 0, 0})) {
    joint_->node_count = 1 + joint_->lower.node_count() + joint_->upper.node_count();
    joint_->reference_count = joint_->lower.reference_count() + joint_->upper.reference_count();
}

std::uint64_t TreePart::node_count() const noexcept {
    return joint_ ? joint_->node_count : piece_.nodes.size();
}

std::uint64_t TreePart::reference_count() const noexcept {
    return joint_ ? joint_->reference_count : piece_.references.size();
}

/// Copies the pieces to their places in the whole.
class Assembly {
public:
    explicit Assembly(Subtree& whole) : whole_(whole) {}

    // Where a part goes: its root, the nodes below it, its references.
    struct Place {
        std::uint32_t root;
        std::uint32_t below;
        std::uint32_t references;
    };

    void put(TreePart&& part, Place place) {
        if (part.joint_ == nullptr) {
            put_piece(part.piece_, place);
            part.piece_ = {};
            part.bytes_.release();
            return;
        }
        TreePart::Joint& joint = *part.joint_;
        whole_.nodes[place.root] = KdNode::make_inner(joint.plane, joint.planar_side, place.below);
        const auto lower_nodes = static_cast<std::uint32_t>(joint.lower.node_count());
        const auto lower_references = static_cast<std::uint32_t>(joint.lower.reference_count());
        const Place lower{place.below, place.below + 2, place.references};
        const Place upper{place.below + 1, place.below + 1 + lower_nodes,
                          place.references + lower_references};
        const auto put_lower = [&] { put(std::move(joint.lower), lower); };
        const auto put_upper = [&] { put(std::move(joint.upper), upper); };
        constexpr std::uint64_t parallel_node_count = 32768;
        if (joint.node_count < parallel_node_count) {
            put_lower();
            put_upper();
        } else {
            parallel_invoke(put_lower, put_upper);
        }
        part.joint_.reset();
    }

private:
    void put_piece(const Subtree& piece, Place place) {
        // Node i >= 1 of the piece lands at below + i - 1.
        const std::uint32_t node_offset = place.below - 1;
        whole_.nodes[place.root] = relocated(piece.nodes[0], node_offset, place.references);
        for (std::size_t i = 1; i < piece.nodes.size(); ++i) {
            whole_.nodes[node_offset + i] =
                relocated(piece.nodes[i], node_offset, place.references);
        }
        std::copy(piece.references.begin(), piece.references.end(),
                  whole_.references.begin() + place.references);
    }

    Subtree& whole_;
};

Subtree assemble(TreePart&& part, MemoryMeter* meter) {
    require_possible(part.node_count(), part.reference_count());
    Subtree whole;
    whole.nodes.resize(part.node_count());
    whole.references.resize(part.reference_count());
    const MeteredBytes bytes(meter, whole.capacity_bytes());
    Assembly(whole).put(std::move(part), {0, 1, 0});
    return whole;
}

}  // namespace coppice::inline v0
