#include "coppice/tree/bvh8.h"

#include "coppice/base/error.h"

#include <utility>

namespace coppice::inline v0 {

Bvh8Node make_empty_bvh8_node() noexcept {
    Bvh8Node node;
    for (std::size_t slot = 0; slot < bvh8_width; ++slot) {
        node.set(slot, Aabb{}, Bvh8Child::make_empty());
    }
    return node;
}

Bvh8::Bvh8() {
    const auto root = std::make_shared<const Bvh8Node>(make_empty_bvh8_node());
    nodes_ = {root.get(), 1};
    storage_ = root;
}

Bvh8::Bvh8(std::shared_ptr<const void> storage, std::span<const Bvh8Node> nodes,
           std::span<const TriangleBlock> blocks, const Aabb& bounds)
    : storage_(std::move(storage)), nodes_(nodes), blocks_(blocks), bounds_(bounds) {
    if (nodes_.empty()) {
        throw Error(ErrorCode::invalid_argument,
                    "an 8-wide tree without nodes: pass at least a root");
    }
}

}  // namespace coppice::inline v0
