#include "builders/top_tree.h"

#include <cstddef>

namespace coppice::inline v0 {

std::uint32_t TopTree::split(std::uint32_t node, SplitPlane plane, PlanarSide planar_side) {
    const auto lower = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node] = {plane, lower, planar_side, false};
    nodes_.resize(nodes_.size() + 2);
    return lower;
}

void TopTree::number_cells() {
    cell_count_ = 0;
    std::vector<std::uint32_t> waiting{0};
    while (!waiting.empty()) {
        Node& node = nodes_[waiting.back()];
        waiting.pop_back();
        if (node.is_cell) {
            node.index = cell_count_++;
        } else {
            waiting.push_back(node.index + 1);
            waiting.push_back(node.index);
        }
    }
}

}  // namespace coppice::inline v0
