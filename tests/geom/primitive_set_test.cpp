#include "coppice/geom/primitive_set.h"

#include "coppice/builders/build_tree.h"
#include "coppice/tree/validate.h"

#include "support/meshes.h"
#include "support/sphere_set.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace coppice::test {
namespace {

static_assert(PrimitiveSet<SphereSet>);
static_assert(PrimitiveSet<BoxSet>);
static_assert(!PrimitiveSet<int>);
static_assert(!PrimitiveSet<Aabb>);
static_assert(std::is_convertible_v<const SphereSet&, PrimitiveSetView>);
static_assert(!std::is_convertible_v<int, PrimitiveSetView>);
static_assert(std::is_trivially_copyable_v<PrimitiveSetView>);

TEST(PrimitiveSetView, ForwardsToTheSet) {
    const TriangleMesh mesh = make_soup(10, 0.5F, 1);
    const TriangleMeshView triangles = mesh.view();
    const PrimitiveSetView view = triangles;
    const Aabb box{{0, 0, 0}, {0.5F, 0.5F, 0.5F}};
    ASSERT_EQ(view.size(), 10U);
    for (std::uint32_t id = 0; id < 10; ++id) {
        EXPECT_EQ(view.bounds(id), triangles.bounds(id));
        EXPECT_EQ(view.clipped_bounds(id, box), triangles.clipped_bounds(id, box));
    }
}

TEST(PrimitiveSetView, CopiesSeeTheSameSet) {
    const SphereSet spheres{{{{1, 2, 3}, 1.0F}}};
    const PrimitiveSetView view = spheres;
    PrimitiveSetView copy = view;
    EXPECT_EQ(copy.bounds(0), spheres.bounds(0));
    const SphereSet others{{{{7, 7, 7}, 2.0F}, {{0, 0, 0}, 1.0F}}};
    copy = others;
    EXPECT_EQ(copy.size(), 2U);
    EXPECT_EQ(view.size(), 1U);
}

class UserDefinedSet : public testing::TestWithParam<double> {};

TEST_P(UserDefinedSet, OfSpheresBuilds) {
    const SphereSet spheres = make_spheres(500, 11);
    for (const LeafRefinement leaf_refinement : {LeafRefinement::none, LeafRefinement::kd}) {
        const auto [tree, report] = build_kd_tree(spheres, {.sample = {.rate = GetParam()},
                                                            .split = {.max_leaf = 4},
                                                            .leaf_refinement = leaf_refinement});
        EXPECT_TRUE(validate(tree, spheres).empty());
        EXPECT_GT(report.statistics.inner_count, 3U);
    }
}

TEST_P(UserDefinedSet, OfBoxesWithPlainClippingBuilds) {
    const BoxSet boxes = make_box_set(500, 12);
    const KdTree tree = build_kd_tree(boxes, {.sample = {.rate = GetParam()}}).tree;
    EXPECT_TRUE(validate(tree, boxes).empty());
}

INSTANTIATE_TEST_SUITE_P(Percent, UserDefinedSet, testing::Values(1.0, 0.1, 0.01),
                         [](const auto& each) {
                             return std::to_string(static_cast<int>(100 * each.param));
                         });

}  // namespace
}  // namespace coppice::test
