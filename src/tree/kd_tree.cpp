#include "coppice/tree/kd_tree.h"

#include "coppice/base/error.h"

#include <algorithm>
#include <utility>

namespace coppice::inline v0 {
namespace {

constexpr KdNode empty_leaf;

}  // namespace

KdTree::KdTree() noexcept : nodes_(&empty_leaf, 1) {}

KdTree::KdTree(std::vector<KdNode> nodes, std::vector<std::uint32_t> references, const Aabb& bounds)
    : KdTree(std::make_shared<Arrays>(Arrays{std::move(nodes), std::move(references)}), bounds) {}

KdTree::KdTree(std::shared_ptr<Arrays> arrays, const Aabb& bounds)
    : KdTree(nullptr, arrays->nodes, arrays->references, bounds) {
    arrays_ = std::move(arrays);
}

KdTree::KdTree(std::shared_ptr<const void> storage, std::span<const KdNode> nodes,
               std::span<const std::uint32_t> references, const Aabb& bounds)
    : storage_(std::move(storage)), nodes_(nodes), references_(references), bounds_(bounds) {
    if (nodes_.empty())
        throw Error(ErrorCode::invalid_argument, "a k-d tree without nodes: pass at least a root");
}

std::vector<KdNode> KdTree::release_nodes() {
    const KdTree released = std::exchange(*this, KdTree());
    if (released.arrays_.use_count() == 1) return std::move(released.arrays_->nodes);
    return {released.nodes_.begin(), released.nodes_.end()};
}

bool operator==(const KdTree& a, const KdTree& b) noexcept {
    return a.bounds_ == b.bounds_ && std::ranges::equal(a.nodes_, b.nodes_) &&
           std::ranges::equal(a.references_, b.references_);
}

Skeleton::Skeleton(KdTree&& tree) : bounds_(tree.bounds_) {
    nodes_ = tree.release_nodes();
    for (KdNode& node : nodes_) {
        if (!node.is_leaf()) continue;
        const bool is_empty = node.reference_count() == 0;
        node = KdNode::make_leaf(0, 0, is_empty ? SampleContent::none : SampleContent::some);
    }
}

}  // namespace coppice::inline v0
