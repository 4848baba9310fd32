#include "build/horizon.h"

#include "coppice/build/build_on_sample.h"
#include "coppice/build/draw_sample.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::test {
namespace {

// The fragments of a node's cells, by going down level by level.
void divide_all(const Horizon& horizon, std::uint32_t index, std::vector<Fragment> fragments,
                const Division& division, std::vector<std::vector<Fragment>>& of_cells) {
    const Horizon::Node& node = horizon.nodes()[index];
    if (node.lower == Horizon::Node::is_cell) {
        of_cells[node.cell] = std::move(fragments);
        return;
    }
    Partition sides = partition(fragments, node.plane, node.planar_side, division);
    divide_all(horizon, node.lower, sides.take_below(), division, of_cells);
    divide_all(horizon, node.lower + 1, sides.take_above(), division, of_cells);
}

bool are_equal(const std::vector<Fragment>& a, const std::vector<Fragment>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Fragment& p, const Fragment& q) {
                          return p.box == q.box && p.id == q.id && p.weight == q.weight;
                      });
}

// Many levels at once give what they give one by one, bit for bit.
TEST(Horizon, DistributesAsDivisionsDo_5) {
    for (const TriangleMesh& mesh : {make_soup(20'000, 0.005F, 5), make_boxes(12)}) {
        const TriangleMeshView view = mesh.view();
        BuildOptions options;
        options.sample.rate = 0.05;
        options.split.max_leaf = 4;
        const KdTree tree = build_on_sample(view, draw_sample(view, options.sample), options);
        const Division division{view, Clipping::perfect};
        for (const int level_count : {1, 5, 60}) {
            const Horizon horizon(tree.nodes(), {0, tree.bounds(), 0}, level_count,
                                  [](std::uint32_t index) { return index % 7 == 6; });
            std::vector<std::vector<Fragment>> expected(horizon.cells().size());
            divide_all(horizon, 0, whole_fragments(view), division, expected);
            const auto found = horizon.distribute(whole_fragments(view), division);
            ASSERT_EQ(found.size(), expected.size());
            for (std::size_t cell = 0; cell < found.size(); ++cell) {
                EXPECT_TRUE(are_equal(found[cell], expected[cell])) << cell;
                EXPECT_LE(horizon.cells()[cell].depth, level_count);
            }
        }
    }
}

}  // namespace
}  // namespace coppice::test
