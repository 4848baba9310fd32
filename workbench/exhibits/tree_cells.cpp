// What the tree inspector draws of a tree. Two walks: one counts the nodes of each level, the
// second sums costs and references from the leaves up and keeps the nodes that were chosen. Nothing
// is kept per node, so that trees of any size can be looked at. Cost O(nodes). Costs are weighted
// by the box's area, which makes them sums: W(leaf) = SA t_isect n, W(inner) = SA t_trav + W(below)
// + W(above); a node's share of the tree's cost is W over the root's. Source: [MacDonaldBooth1990],
// in the form of [Tsiompikas2022] eq. 4 to 6.

#include "exhibits/tree_cells.h"

#include "coppice/tree/walk.h"

#include <cstdint>

namespace coppice::lab {

namespace {

/// A node's sums over itself and all below.
struct Sums {
    double weighted_cost = 0.0;
    std::uint64_t reference_count = 0;
};

class CellCollector {
public:
    CellCollector(const KdTree& tree, const SahCostModel& model, std::size_t most_shown)
        : tree_(tree), model_(model), most_shown_(most_shown) {
        walk(tree, [this](const VisitedNode& node) { count(node); });
        met_.resize(levels_.size());
    }

    [[nodiscard]] std::vector<report::CellLevel> collect() {
        const double whole = sum({0, tree_.bounds(), 0}).weighted_cost;
        for (report::CellLevel& level : levels_) {
            for (report::Cell& cell : level.shown) {
                cell.cost_share = whole > 0.0 ? cell.cost_share / whole : 0.0;
            }
        }
        return std::move(levels_);
    }

private:
    void count(const VisitedNode& node) {
        const auto depth = static_cast<std::size_t>(node.depth);
        if (depth == levels_.size()) levels_.emplace_back();
        ++levels_[depth].cell_count;
        const KdNode& tree_node = tree_.nodes()[node.index];
        if (tree_node.is_leaf() && tree_node.reference_count() == 0) ++levels_[depth].empty_count;
    }

    /// Whether the next node of a level is one of those shown: they split it into equal parts.
    [[nodiscard]] bool choose(std::size_t depth) {
        const std::uint64_t count = levels_[depth].cell_count;
        const std::uint64_t i = met_[depth]++;
        return count <= most_shown_ || i * most_shown_ / count != (i + 1) * most_shown_ / count;
    }

    // NOLINTNEXTLINE(misc-no-recursion): as deep as the tree, which is at most KdTree::max_depth
    Sums sum(const VisitedNode& at) {
        const auto depth = static_cast<std::size_t>(at.depth);
        const bool is_shown = choose(depth);
        const std::size_t place = levels_[depth].shown.size();
        if (is_shown) levels_[depth].shown.push_back({at.box});
        const KdNode& node = tree_.nodes()[at.index];
        Sums sums;
        if (node.is_leaf()) {
            sums.reference_count = node.reference_count();
            sums.weighted_cost = at.box.surface_area() * model_.intersection *
                                 static_cast<double>(sums.reference_count);
        } else {
            const SplitPlane plane = node.plane();
            const Sums lower = sum({node.lower_child(), below(at.box, plane), at.depth + 1});
            const Sums upper = sum({node.upper_child(), above(at.box, plane), at.depth + 1});
            sums.reference_count = lower.reference_count + upper.reference_count;
            sums.weighted_cost = at.box.surface_area() * model_.traversal + lower.weighted_cost +
                                 upper.weighted_cost;
        }
        if (is_shown) {
            report::Cell& cell = levels_[depth].shown[place];
            cell.cost_share = sums.weighted_cost;
            cell.reference_count = sums.reference_count;
        }
        return sums;
    }

    const KdTree& tree_;
    const SahCostModel& model_;
    std::uint64_t most_shown_;
    std::vector<report::CellLevel> levels_;
    std::vector<std::uint64_t> met_;  // nodes of each level so far
};

}  // namespace

std::vector<report::CellLevel> collect_cells(const KdTree& tree, const SahCostModel& model,
                                             std::size_t most_shown) {
    return CellCollector(tree, model, most_shown).collect();
}

}  // namespace coppice::lab
