// A cost model of one's own: what a tree is built for, and is measured by.
#include <coppice/coppice.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

namespace {

// Eight triangles are tested at the price of one, so that a leaf costs by the batch.
class Batches final : public coppice::CostModel {
public:
    [[nodiscard]] double traversal_cost() const noexcept override { return 1.0; }

    [[nodiscard]] double leaf_cost(double count) const noexcept override {
        return 2.0 * std::ceil(count / 8.0);
    }
};

}  // namespace

int main() {
    const coppice::TriangleMesh mesh = coppice::load_mesh("bunny.obj");
    const coppice::SahCostModel usual;

    // Other constants are the smallest change: say that a profiler found a triangle to cost six
    // times what an inner node does, and that empty space is worth little extra.
    const coppice::SahCostModel constants{
        .traversal = 1.0, .intersection = 6.0, .empty_bonus = 0.2};
    // An object replaces the formula.
    const coppice::SahCostModel batches{.custom = std::make_shared<const Batches>()};

    for (const auto& [name, model] :
         {std::pair{"usual", usual}, {"constants", constants}, {"batches", batches}}) {
        const auto [tree, report] = coppice::build_kd_tree(mesh.view(), {.cost = model});
        std::printf("built for %s: %zu nodes, cost %.1f, by batches %.1f\n", name,
                    tree.nodes().size(), report.statistics.sah_cost,
                    coppice::measure(tree, batches).sah_cost);
    }
}
