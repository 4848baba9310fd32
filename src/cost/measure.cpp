#include "coppice/cost/measure.h"

#include "coppice/tree/walk.h"

#include <algorithm>

namespace coppice {
namespace {

// One recursion does both: costs come up from the leaves, and the probability that a ray which
// meets the root's box also meets this node's goes down.
class Measurement {
public:
    Measurement(const KdTree& tree, const SahCostModel& model) : tree_(tree), model_(model) {}

    TreeStatistics run() {
        statistics_.sah_cost = visit({0, tree_.bounds(), 0}, 1.0);
        finish();
        return std::move(statistics_);
    }

private:
    // Returns the node's cost, given that a ray meets it.
    double visit(const VisitedNode& at, double probability) {
        const KdNode& node = tree_.nodes()[at.index];
        if (node.is_leaf()) return visit_leaf(node, at.depth, probability);
        ++statistics_.inner_count;
        statistics_.expected_inner_visits += probability;
        add_cost(at.depth, probability * model_.traversal);

        const double area = at.box.surface_area();
        double cost = model_.traversal;
        const auto visit_child = [&](std::uint32_t child, const Aabb& box) {
            const double share = area > 0.0 ? box.surface_area() / area : 0.0;
            cost += share * visit({child, box, at.depth + 1}, share * probability);
        };
        visit_child(node.lower_child(), below(at.box, node.plane()));
        visit_child(node.upper_child(), above(at.box, node.plane()));
        return cost;
    }

    double visit_leaf(const KdNode& leaf, int depth, double probability) {
        const std::uint32_t count = leaf.reference_count();
        const double cost = model_.leaf_cost(count);
        ++statistics_.leaf_count;
        statistics_.single_primitive_leaf_count += count == 1 ? 1 : 0;
        statistics_.empty_leaf_count += count == 0 ? 1 : 0;
        statistics_.reference_count += count;
        statistics_.expected_leaf_visits += probability;
        statistics_.expected_primitive_tests += probability * count;
        statistics_.max_level = std::max(statistics_.max_level, depth);
        add_cost(depth, probability * cost);
        ++statistics_.depth_histogram[static_cast<std::size_t>(depth)];
        return cost;
    }

    void add_cost(int depth, double cost) {
        const auto level = static_cast<std::size_t>(depth);
        if (level >= statistics_.cost_share_by_depth.size()) {
            statistics_.cost_share_by_depth.resize(level + 1);
            statistics_.depth_histogram.resize(level + 1);
        }
        statistics_.cost_share_by_depth[level] += cost;
    }

    void finish() {
        statistics_.node_count = statistics_.inner_count + statistics_.leaf_count;
        statistics_.mean_leaf_size = static_cast<double>(statistics_.reference_count) /
                                     static_cast<double>(statistics_.leaf_count);
        double total = 0.0;
        for (const double cost : statistics_.cost_share_by_depth)
            total += cost;
        for (double& share : statistics_.cost_share_by_depth) {
            share = total > 0.0 ? share / total : 0.0;
        }
    }

    const KdTree& tree_;
    const SahCostModel& model_;
    TreeStatistics statistics_;
};

}  // namespace

TreeStatistics measure(const KdTree& tree, const SahCostModel& model) {
    return Measurement(tree, model).run();
}

}  // namespace coppice
