#include "builders/kd/kd_builder.h"

#include "builders/kd/partition.h"
#include "support/meshes.h"
#include "support/tree_checks.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

constexpr TerminationRule to_the_end{0, 1, 50, SplitSearch::until_it_pays, 1e9};

KdTree tree_of(const TriangleMesh& mesh, const TerminationRule& stop, int depth = 0,
               const KdOptions& options = {}) {
    const TriangleMeshView view = mesh.view();
    const Aabb box = bounds_of_all(view);
    Subtree built =
        assemble(KdBuilder(view, options, stop).build(whole_prim_refs(view), {box, depth}));
    return {std::move(built.nodes), std::move(built.references), box};
}

TEST(KdBuilder, OfNothingIsAnEmptyLeaf) {
    const KdTree tree = tree_of({}, to_the_end);
    EXPECT_TRUE(tree == KdTree{});
}

TEST(KdBuilder, MakesSoundTreesInOrder) {
    const TriangleMesh mesh = make_soup(300, 0.1F, 1);
    for (const SplitSearch search : {SplitSearch::first_offer, SplitSearch::until_it_pays}) {
        const KdTree tree = tree_of(mesh, {1, 3, 30, search, 1e9});
        EXPECT_TRUE(is_sound(tree, mesh.view()));
        EXPECT_TRUE(is_in_order(tree));
    }
}

TEST(KdBuilder, CountsDepthFromWhereItStarts) {
    const TriangleMesh mesh = make_soup(300, 0.1F, 1);
    EXPECT_EQ(depth_of(tree_of(mesh, {0, 1, 7, SplitSearch::until_it_pays, 1e9}, 0)), 7);
    EXPECT_EQ(depth_of(tree_of(mesh, {0, 1, 7, SplitSearch::until_it_pays, 1e9}, 5)), 2);
    EXPECT_EQ(depth_of(tree_of(mesh, {0, 1, 7, SplitSearch::until_it_pays, 1e9}, 7)), 0);
    EXPECT_EQ(depth_of(tree_of(mesh, {0, 1, 7, SplitSearch::until_it_pays, 1e9}, 50)), 0);
}

TEST(KdBuilder, LooksOnAllAxesUntilASplitPays) {
    // Sheets stacked along y in a node longest in x: only cuts between them pay.
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh = joined(std::move(mesh),
                      make_sheet(1, {0, static_cast<float>(i), 0}, {20, 0, 0}, {0, 0, 9}));
    }
    add_triangle(mesh, {Vec3f{0, 0, 0}, Vec3f{19, 0, 0}, Vec3f{0, 1, 0}});  // an offer on x
    const KdTree first = tree_of(mesh, {1, 1, 50, SplitSearch::first_offer, 1e9});
    const KdTree best = tree_of(mesh, {1, 1, 50, SplitSearch::until_it_pays, 1e9});
    EXPECT_EQ(first.nodes().size(), 1U);
    ASSERT_GT(best.nodes().size(), 3U);
    EXPECT_EQ(best.root().axis(), Axis::y);
}

TEST(KdBuilder, SplitsSinglePrimitivesOnlyIfThatPays) {
    const TriangleMesh mesh = make_triangle({Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{0, 1, 1}});
    EXPECT_EQ(tree_of(mesh, to_the_end).nodes().size(), 1U);
    // Cheap traversal: empty space around one triangle is worth cutting off.
    const KdOptions cheap{.cost = {.traversal = 0.0}};
    const TriangleMeshView view = mesh.view();
    const Aabb large{{-9, -9, -9}, {9, 9, 9}};
    Subtree built =
        assemble(KdBuilder(view, cheap, to_the_end).build(whole_prim_refs(view), {large}));
    EXPECT_EQ(built.nodes.size(), 13U) << "six cuts";
}

TEST(KdBuilder, KeepsToItsLimitOfDuplication) {
    const TriangleMesh mesh = make_soup(300, 1.0F, 3);
    const auto reference_count = [&](double max_duplication) {
        const TerminationRule stop{0, 1, 50, SplitSearch::until_it_pays, max_duplication};
        const KdTree tree = tree_of(mesh, stop, 0, {.cost = {.traversal = 0.1}});
        EXPECT_TRUE(is_sound(tree, mesh.view()));
        return static_cast<double>(tree.references().size());
    };
    EXPECT_GT(reference_count(1e9), 4.0 * 300.0);
    EXPECT_LE(reference_count(2.0), 4.0 * 300.0) << "twice, and the last split of each path";
    EXPECT_LT(reference_count(2.0), reference_count(4.0));
}

}  // namespace
}  // namespace coppice::test
