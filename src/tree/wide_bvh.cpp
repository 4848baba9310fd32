#include "coppice/tree/wide_bvh.h"

#include "coppice/base/error.h"

#include <utility>

namespace coppice {

WideNode make_empty_wide_node() noexcept {
    WideNode node;
    for (std::size_t slot = 0; slot < wide_width; ++slot)
        node.set(slot, Aabb{}, WideChild{});
    return node;
}

WideBvh::WideBvh() : nodes_(1, make_empty_wide_node()) {}

WideBvh::WideBvh(BigVector<WideNode> nodes, BigVector<TriangleBlock> blocks, const Aabb& bounds)
    : nodes_(std::move(nodes)), blocks_(std::move(blocks)), bounds_(bounds) {
    if (nodes_.empty()) {
        throw Error(ErrorCode::invalid_argument, "a wide tree needs at least a root");
    }
}

}  // namespace coppice
