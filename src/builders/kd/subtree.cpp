#include "builders/kd/subtree.h"

#include "coppice/base/error.h"

#include <fmt/format.h>

#include <limits>

namespace coppice::inline v0 {
namespace {

void require_at_most(std::uint64_t count, std::uint64_t limit, const char* what) {
    if (count <= limit) return;
    throw Error(ErrorCode::limit, fmt::format("the tree would have {} {}; at most {} are possible",
                                              count, what, limit));
}

constexpr std::uint64_t max_reference_count = std::numeric_limits<std::uint32_t>::max();

}  // namespace

void make_leaf(Subtree& tree, std::uint32_t slot, std::span<const PrimRef> prim_refs) {
    const auto first = static_cast<std::uint32_t>(tree.references.size());
    require_at_most(prim_refs.size(), KdNode::max_payload, "references in a leaf");
    require_at_most(first + prim_refs.size(), max_reference_count, "references");
    for (const PrimRef& prim_ref : prim_refs) {
        tree.references.push_back(prim_ref.id);
    }
    tree.nodes[slot] = KdNode::make_leaf(first, static_cast<std::uint32_t>(prim_refs.size()));
}

std::uint32_t make_inner(Subtree& tree, std::uint32_t slot, SplitPlane plane,
                         PlanarSide planar_side) {
    require_at_most(tree.nodes.size() + 2, KdNode::max_payload, "nodes");
    const auto lower_child = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes.resize(tree.nodes.size() + 2);
    tree.nodes[slot] = KdNode::make_inner(plane, planar_side, lower_child);
    return lower_child;
}

KdNode relocated(const KdNode& node, std::uint32_t node_offset,
                 std::uint32_t reference_offset) noexcept {
    if (node.is_leaf()) {
        return KdNode::make_leaf(node.first_reference() + reference_offset, node.reference_count(),
                                 node.in_sample());
    }
    return KdNode::make_inner(node.plane(), node.planar_side(), node.lower_child() + node_offset);
}

void require_possible(std::uint64_t node_count, std::uint64_t reference_count) {
    require_at_most(node_count, KdNode::max_payload, "nodes");
    require_at_most(reference_count, max_reference_count, "references");
}

}  // namespace coppice::inline v0
