#include "coppice/builders/refill.h"

#include "coppice/builders/build_on_sample.h"
#include "coppice/builders/draw_sample.h"
#include "coppice/builders/empty_leaves.h"

#include "builders/descend.h"
#include "support/meshes.h"
#include "support/primitives.h"
#include "support/sphere_set.h"
#include "support/tree_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace coppice::test {
namespace {

using testing::ElementsAre;

constexpr Aabb at(float lower, float upper) {
    return {{lower, 0, 0}, {upper, 1, 1}};
}

// A skeleton of one plane at x = 2, with leaves that were empty in the sample or not.
Skeleton one_plane(PlanarSide side, std::uint32_t lower_count, std::uint32_t upper_count) {
    std::vector<std::uint32_t> references(lower_count + upper_count);
    std::iota(references.begin(), references.end(), 0U);
    return Skeleton(
        KdTree({KdNode::make_inner({Axis::x, 2.0F}, side, 1), KdNode::make_leaf(0, lower_count),
                KdNode::make_leaf(lower_count, upper_count)},
               references, at(0, 4)));
}

TEST(Refill, PutsEveryPrimitiveWhereItReaches) {
    const BoxSet boxes({at(0, 1), at(1, 2), at(1, 3), at(2, 3), at(2, 2)});
    const KdTree low = refill(one_plane(PlanarSide::below, 1, 1), boxes, {});
    EXPECT_THAT(low.references(low.nodes()[1]), ElementsAre(0, 1, 2, 4));
    EXPECT_THAT(low.references(low.nodes()[2]), ElementsAre(2, 3));
    const KdTree high = refill(one_plane(PlanarSide::above, 1, 1), boxes, {});
    EXPECT_THAT(high.references(high.nodes()[1]), ElementsAre(0, 1, 2));
    EXPECT_THAT(high.references(high.nodes()[2]), ElementsAre(2, 3, 4));
    EXPECT_EQ(low.bounds(), at(0, 4));
    EXPECT_EQ(low.nodes()[0].plane(), (SplitPlane{Axis::x, 2.0F}));
}

TEST(Refill, PutsAPointIntoOneLeaf) {
    const std::vector<Vec3f> points{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    const KdTree tree = refill(one_plane(PlanarSide::above, 1, 1), PointCloudView(points), {});
    EXPECT_THAT(tree.references(tree.nodes()[1]), ElementsAre(0));
    EXPECT_THAT(tree.references(tree.nodes()[2]), ElementsAre(1, 2));
}

TEST(Refill, RecordsWhichLeavesWereEmptyInTheSampleOnly) {
    const BoxSet boxes({at(0, 1), at(3, 4)});
    const auto content_of = [&](std::uint32_t lower_count, std::uint32_t upper_count,
                                const BoxSet& filled) {
        const KdTree tree =
            refill(one_plane(PlanarSide::below, lower_count, upper_count), filled, {});
        return std::pair(tree.nodes()[1].in_sample(), tree.nodes()[2].in_sample());
    };
    EXPECT_EQ(content_of(1, 0, boxes), std::pair(SampleContent::some, SampleContent::none));
    EXPECT_EQ(content_of(0, 1, boxes), std::pair(SampleContent::none, SampleContent::some));
    EXPECT_EQ(content_of(1, 1, boxes), std::pair(SampleContent::some, SampleContent::some));
    // What is truly empty is no matter of the sample.
    EXPECT_EQ(content_of(1, 0, BoxSet({at(0, 1)})),
              std::pair(SampleContent::some, SampleContent::some));
}

TEST(Refill, OfNothingIsEmpty) {
    const KdTree tree = refill(one_plane(PlanarSide::below, 1, 1), BoxSet({}), {});
    EXPECT_EQ(tree.nodes().size(), 3U);
    EXPECT_TRUE(tree.references().empty());
    EXPECT_TRUE(refill(Skeleton(KdTree{}), BoxSet({}), {}) == KdTree{});
}

TEST(Refill, OfOneLeafIsAll) {
    const TriangleMesh mesh = make_soup(100, 0.1F, 1);
    const KdTree leaf({KdNode{}}, {}, bounds_of(mesh.vertices));
    const KdTree tree = refill(Skeleton(KdTree(leaf)), mesh.view(), {});
    EXPECT_EQ(tree.references().size(), 100U);
    EXPECT_TRUE(is_sound(tree, mesh.view()));
}

class RefillAtRate : public testing::TestWithParam<double> {};

TEST_P(RefillAtRate, GivesTheLeavesOfADescent) {
    const Primitives scene(make_terrain(60, 5));  // large enough to be filled in parallel
    for (const PrimitiveKind kind : {PrimitiveKind::triangles, PrimitiveKind::points}) {
        for (const Clipping clipping : {Clipping::perfect, Clipping::bounding_box}) {
            const PrimitiveSetView primitives = scene.of(kind);
            const KdOptions options{.sample = {.rate = GetParam()},
                                    .split = {.max_leaf = 4, .clipping = clipping}};
            const Sample sample = draw_sample(primitives, options.sample);
            const KdTree sampled = build_on_sample(primitives, sample, options);
            const KdTree tree = refill(empty_leaves(KdTree(sampled)), primitives, options);
            EXPECT_TRUE(is_sound(tree, primitives));
            EXPECT_TRUE(is_in_order(tree));
            EXPECT_EQ(distinct_reference_count(tree), primitives.size());
            ASSERT_EQ(tree.nodes().size(), sampled.nodes().size());
            descend(tree, primitives, clipping,
                    [&](const VisitedNode& visited, const std::vector<PrimRef>& prim_refs) {
                        const KdNode& node = tree.nodes()[visited.index];
                        const KdNode& before = sampled.nodes()[visited.index];
                        ASSERT_EQ(node.is_leaf(), before.is_leaf());
                        if (!node.is_leaf()) {
                            EXPECT_EQ(node, before);
                            return;
                        }
                        const auto ids = tree.references(node);
                        ASSERT_EQ(ids.size(), prim_refs.size());
                        for (std::size_t i = 0; i < ids.size(); ++i) {
                            EXPECT_EQ(ids[i], prim_refs[i].id);
                        }
                        const bool was_empty = before.reference_count() == 0;
                        EXPECT_EQ(node.in_sample() == SampleContent::none,
                                  was_empty && !prim_refs.empty());
                    });
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Percent, RefillAtRate, testing::Values(1.0, 0.5, 0.1, 0.01),
                         [](const auto& each) {
                             return std::to_string(std::lround(100 * each.param));
                         });

}  // namespace
}  // namespace coppice::test
