#include "coppice/tree/wide_bvh.h"

#include "coppice/base/error.h"

#include <utility>

namespace coppice {

WideNode make_empty_wide_node() noexcept {
    WideNode node;
    for (std::size_t slot = 0; slot < wide_width; ++slot) {
        node.set(slot, Aabb{}, WideChild::make_empty());
    }
    return node;
}

WideBvh::WideBvh() {
    const auto root = std::make_shared<const WideNode>(make_empty_wide_node());
    nodes_ = {root.get(), 1};
    storage_ = root;
}

WideBvh::WideBvh(std::shared_ptr<const void> storage, std::span<const WideNode> nodes,
                 std::span<const TriangleBlock> blocks, const Aabb& bounds)
    : storage_(std::move(storage)), nodes_(nodes), blocks_(blocks), bounds_(bounds) {
    if (nodes_.empty()) {
        throw Error(ErrorCode::invalid_argument, "a wide tree needs at least a root");
    }
}

}  // namespace coppice
