// One recursion computes both: costs are summed from the leaves up, and the probability that a ray
// which meets the root's box also meets a node's box is passed down.
// Source: [Tsiompikas2022] eq. 4 to 6.

#include "coppice/cost/measure.h"

#include "coppice/base/parallel.h"
#include "coppice/tree/walk.h"

#include "cost/statistics_sum.h"

#include <utility>

namespace coppice::inline v0 {
namespace {

// Cancellation is checked down to this depth of a binary tree; subtrees below take negligible time.
constexpr int depth_of_looks = 12;

class KdMeasurement {
public:
    KdMeasurement(const KdTree& tree, const SahCostModel& model) : tree_(tree), model_(model) {}

    TreeStatistics run() && {
        const double cost = visit({0, tree_.bounds(), 0}, 1.0);
        TreeStatistics statistics = std::move(sum_).finish();
        statistics.sah_cost = cost;
        return statistics;
    }

private:
    // Returns the node's cost for a ray that meets it.
    double visit(const VisitedNode& at, double probability) {
        if (at.depth <= depth_of_looks) throw_if_cancelled();
        const KdNode& node = tree_.nodes()[at.index];
        if (node.is_leaf()) {
            const std::uint32_t count = node.reference_count();
            const double cost = model_.leaf_cost(count);
            sum_.add_leaf(at.depth, probability, count, count, cost);
            return cost;
        }
        sum_.add_inner(at.depth, probability, model_.traversal_cost());
        const double area = at.box.surface_area();
        double cost = model_.traversal_cost();
        const auto visit_child = [&](std::uint32_t child, const Aabb& box) {
            const double share = area > 0.0 ? box.surface_area() / area : 0.0;
            cost += share * visit({child, box, at.depth + 1}, share * probability);
        };
        visit_child(node.lower_child(), below(at.box, node.plane()));
        visit_child(node.upper_child(), above(at.box, node.plane()));
        return cost;
    }

    const KdTree& tree_;
    const SahCostModel& model_;
    StatisticsSum sum_;
};

class Bvh8Measurement {
public:
    Bvh8Measurement(const Bvh8& tree, const SahCostModel& model)
        : tree_(tree), model_(model), root_area_(tree.bounds().surface_area()) {}

    TreeStatistics run() && {
        visit(0, 1.0, 0);
        return std::move(sum_).finish();
    }

private:
    void visit(std::uint32_t index, double probability, int depth) {
        if (depth <= depth_of_looks / 3) throw_if_cancelled();
        sum_.add_inner(depth, probability, model_.traversal_cost());
        const Bvh8Node& node = tree_.nodes()[index];
        for (std::size_t slot = 0; slot < bvh8_width; ++slot) {
            const Bvh8Child child = node.child[slot];
            if (child.is_empty()) continue;
            const double area = node.child_box(slot).surface_area();
            const double p = root_area_ > 0.0 ? area / root_area_ : 0.0;
            if (child.is_leaf()) {
                visit_leaf(child, p, depth + 1);
            } else {
                visit(child.node(), p, depth + 1);
            }
        }
    }

    void visit_leaf(Bvh8Child leaf, double probability, int depth) {
        std::uint64_t count = 0;
        for (const TriangleBlock& block :
             tree_.blocks().subspan(leaf.first_block(), leaf.block_count())) {
            for (const std::uint32_t id : block.id) {
                count += id != TriangleBlock::no_triangle ? 1U : 0U;
            }
        }
        const auto blocks = static_cast<double>(leaf.block_count());
        sum_.add_leaf(depth, probability, count, blocks, model_.leaf_cost(blocks));
    }

    const Bvh8& tree_;
    const SahCostModel& model_;
    double root_area_;
    StatisticsSum sum_;
};

}  // namespace

TreeStatistics measure(const KdTree& tree, const SahCostModel& model) {
    return KdMeasurement(tree, model).run();
}

TreeStatistics measure(const Bvh8& tree, const SahCostModel& model) {
    return Bvh8Measurement(tree, model).run();
}

}  // namespace coppice::inline v0
