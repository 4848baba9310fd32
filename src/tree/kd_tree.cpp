#include "coppice/tree/kd_tree.h"

#include "coppice/base/error.h"

namespace coppice {

KdTree::KdTree(std::vector<KdNode> nodes, std::vector<std::uint32_t> references, const Aabb& bounds)
    : nodes_(std::move(nodes)), references_(std::move(references)), bounds_(bounds) {
    if (nodes_.empty()) throw Error(ErrorCode::invalid_argument, "a k-d tree needs a root node");
}

Skeleton::Skeleton(KdTree&& tree) : nodes_(std::move(tree.nodes_)), bounds_(tree.bounds_) {
    for (KdNode& node : nodes_) {
        if (!node.is_leaf()) continue;
        const bool is_empty = node.reference_count() == 0;
        node = KdNode::make_leaf(0, 0, is_empty ? SampleContent::none : SampleContent::some);
    }
    tree = KdTree{};
}

}  // namespace coppice
