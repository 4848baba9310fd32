#include "builders/kd/top_tree.h"

#include "coppice/builders/build_on_sample.h"
#include "coppice/builders/draw_sample.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::test {
namespace {

// The PrimRefs of a node's cells, by going down level by level.
void divide_all(const TopTree& top_tree, std::uint32_t index, std::vector<PrimRef> prim_refs,
                const Division& division, std::vector<std::vector<PrimRef>>& of_cells) {
    const TopTree::Node& node = top_tree.nodes()[index];
    if (node.is_cell) {
        of_cells[node.index] = std::move(prim_refs);
        return;
    }
    Partition sides = partition(prim_refs, node.plane, node.planar_side, division);
    divide_all(top_tree, node.index, sides.take_below(), division, of_cells);
    divide_all(top_tree, node.index + 1, sides.take_above(), division, of_cells);
}

bool are_equal(const std::vector<PrimRef>& a, const std::vector<PrimRef>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const PrimRef& p, const PrimRef& q) {
                          return p.box == q.box && p.id == q.id && p.weight == q.weight;
                      });
}

// Many levels at once give what they give one by one, bit for bit.
TEST(KdTopTree, DistributesAsDivisionsDo_5) {
    for (const TriangleMesh& mesh : {make_soup(20'000, 0.005F, 5), make_boxes(12)}) {
        const TriangleMeshView view = mesh.view();
        KdOptions options;
        options.sample.rate = 0.05;
        options.split.max_leaf = 4;
        const KdTree tree = build_on_sample(view, draw_sample(view, options.sample), options);
        const Division division{view, Clipping::perfect};
        for (const int level_count : {1, 5, 60}) {
            const KdTopTree top_tree(tree.nodes(), {0, tree.bounds(), 0}, level_count,
                                     [](std::uint32_t index) { return index % 7 == 6; });
            std::vector<std::vector<PrimRef>> expected(top_tree.cells().size());
            divide_all(top_tree, 0, whole_prim_refs(view), division, expected);
            const auto found = top_tree.distribute(whole_prim_refs(view), division);
            ASSERT_EQ(found.size(), expected.size());
            for (std::size_t cell = 0; cell < found.size(); ++cell) {
                EXPECT_TRUE(are_equal(found[cell], expected[cell])) << cell;
                EXPECT_LE(top_tree.cells()[cell].depth, level_count);
            }
        }
    }
}

}  // namespace
}  // namespace coppice::test
