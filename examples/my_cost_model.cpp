// A cost model of one's own: the constants that a tree is built for, and is measured by.
#include <coppice/coppice.h>

#include <cstdio>

int main() {
    const coppice::TriangleMesh mesh = coppice::load_mesh("bunny.obj");

    // Say that a profiler found a triangle to cost six times what an inner node does, and that
    // empty space is worth little extra.
    const coppice::SahCostModel mine{.traversal = 1.0, .intersection = 6.0, .empty_bonus = 0.2};
    const coppice::SahCostModel usual;

    const coppice::KdTree for_mine = coppice::build_kd_tree(mesh.view(), {.cost = mine});
    const coppice::KdTree for_usual = coppice::build_kd_tree(mesh.view(), {.cost = usual});
    for (const auto* tree : {&for_mine, &for_usual}) {
        const coppice::TreeStatistics statistics = coppice::measure(*tree, mine);
        std::printf("%s: %llu nodes, cost %.1f by my model\n",
                    tree == &for_mine ? "built for my model" : "built for the usual one",
                    static_cast<unsigned long long>(tree->nodes().size()), statistics.sah_cost);
    }
}
