#include "build/partition.h"

#include "support/meshes.h"
#include "support/scene_matrix.h"
#include "support/sphere_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::test {
namespace {

using testing::ElementsAre;

constexpr Aabb at(float lower, float upper) {
    return {{lower, 0, 0}, {upper, 1, 1}};
}

std::vector<std::uint32_t> ids_of(const std::vector<Fragment>& fragments) {
    std::vector<std::uint32_t> ids;
    for (const Fragment& fragment : fragments) {
        ids.push_back(fragment.id);
    }
    return ids;
}

TEST(RelationTo, TellsTouchingFromCrossing) {
    constexpr Plane plane{Axis::x, 2.0F};
    static_assert(relation_to(at(0, 1), plane) == PlaneRelation::below);
    static_assert(relation_to(at(0, 2), plane) == PlaneRelation::below);
    static_assert(relation_to(at(0, 3), plane) == PlaneRelation::across);
    static_assert(relation_to(at(2, 3), plane) == PlaneRelation::above);
    static_assert(relation_to(at(3, 4), plane) == PlaneRelation::above);
    static_assert(relation_to(at(2, 2), plane) == PlaneRelation::in_plane);
    static_assert(relation_to(at(1, 1), plane) == PlaneRelation::below);
    static_assert(relation_to(at(3, 3), plane) == PlaneRelation::above);
    EXPECT_EQ(relation_to(at(-0.0F, 0.0F), {Axis::x, 0.0F}), PlaneRelation::in_plane);
    EXPECT_EQ(relation_to(at(0.0F, 0.0F), {Axis::x, -0.0F}), PlaneRelation::in_plane);
    EXPECT_EQ(relation_to(at(-1.0F, -0.0F), {Axis::x, 0.0F}), PlaneRelation::below);
    EXPECT_EQ(relation_to(at(-0.0F, 1.0F), {Axis::x, 0.0F}), PlaneRelation::above);
}

TEST(Partition, KeepsTheOrderAndPutsPlanarsOnTheirSide) {
    const BoxSet boxes({at(0, 1), at(2, 2), at(1, 3), at(3, 4), at(2, 2), at(1, 2), at(2, 3)});
    const std::vector<Fragment> fragments = whole_fragments(boxes);
    const Plane plane{Axis::x, 2.0F};
    for (const Clipping clipping : {Clipping::perfect, Clipping::bounding_box}) {
        const Partition low = partition(fragments, plane, PlanarSide::below, {boxes, clipping});
        EXPECT_THAT(ids_of(low.below), ElementsAre(0, 1, 2, 4, 5));
        EXPECT_THAT(ids_of(low.above), ElementsAre(2, 3, 6));
        const Partition high = partition(fragments, plane, PlanarSide::above, {boxes, clipping});
        EXPECT_THAT(ids_of(high.below), ElementsAre(0, 2, 5));
        EXPECT_THAT(ids_of(high.above), ElementsAre(1, 2, 3, 4, 6));
        EXPECT_EQ(low.below[2].box, at(1, 2));
        EXPECT_EQ(low.above[0].box, at(2, 3));
        EXPECT_EQ(low.below[0].box, at(0, 1));
    }
}

TEST(Partition, ClipsAsAsked) {
    const TriangleMesh mesh = make_triangle({Vec3f{0, 0, 0}, Vec3f{2, 0, 0}, Vec3f{0, 2, 0}});
    const TriangleMeshView view = mesh.view();
    const std::vector<Fragment> fragments = whole_fragments(view);
    const Plane plane{Axis::x, 1.0F};
    const Partition perfect =
        partition(fragments, plane, PlanarSide::below, {view, Clipping::perfect});
    EXPECT_FLOAT_EQ(perfect.above.at(0).box.upper.y, 1.0F);
    EXPECT_EQ(perfect.below.at(0).box.upper.y, 2.0F);
    const Partition plain =
        partition(fragments, plane, PlanarSide::below, {view, Clipping::bounding_box});
    EXPECT_EQ(plain.above.at(0).box.upper.y, 2.0F);
}

// A set that denies its primitives whenever it is asked to clip.
class DenyingSet {
public:
    [[nodiscard]] static std::uint32_t size() { return 1; }

    [[nodiscard]] static Aabb bounds(std::uint32_t) { return at(0, 4); }

    [[nodiscard]] static Aabb clipped_bounds(std::uint32_t, const Aabb&) { return {}; }
};

TEST(Partition, LosesNothingThatClippingDenies) {
    const DenyingSet set;
    const Partition sides = partition(whole_fragments(set), {Axis::x, 1.0F}, PlanarSide::below,
                                      {set, Clipping::perfect});
    ASSERT_EQ(sides.below.size(), 1U);
    ASSERT_EQ(sides.above.size(), 1U);
    EXPECT_EQ(sides.below[0].box, at(0, 1));
    EXPECT_EQ(sides.above[0].box, at(1, 4));
}

class PartitionScene : public testing::TestWithParam<NamedScene> {};

TEST_P(PartitionScene, LosesNothingAndStaysInside) {
    const TriangleMesh mesh = GetParam().make();
    const TriangleMeshView view = mesh.view();
    const std::vector<Fragment> fragments = whole_fragments(view);
    if (fragments.empty()) return;
    Random random(21);
    for (int round = 0; round < 30; ++round) {
        const auto axis = static_cast<Axis>(random.below(3));
        const Fragment& any = fragments[random.below(view.size())];
        const Plane plane{axis, round % 3 == 0
                                    ? any.box.lower[axis]
                                    : random.uniform(any.box.lower[axis], any.box.upper[axis])};
        for (const Clipping clipping : {Clipping::perfect, Clipping::bounding_box}) {
            const Partition sides =
                partition(fragments, plane, PlanarSide::above, {view, clipping});
            std::vector<bool> is_seen(fragments.size(), false);
            for (const Fragment& fragment : sides.below) {
                is_seen[fragment.id] = true;
                const Aabb limits = below(fragments[fragment.id].box, plane);
                EXPECT_TRUE(fragment.box == fragments[fragment.id].box ||
                            intersection(fragment.box, limits) == fragment.box);
                EXPECT_LE(fragment.box.upper[axis], plane.position);
            }
            for (const Fragment& fragment : sides.above) {
                is_seen[fragment.id] = true;
                EXPECT_GE(fragment.box.lower[axis], plane.position);
            }
            EXPECT_TRUE(
                std::all_of(is_seen.begin(), is_seen.end(), [](bool seen) { return seen; }));
            EXPECT_EQ(intersection(bounds_of_all(view), bounds_of(mesh.vertices)),
                      bounds_of_all(view));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seed21, PartitionScene, testing::ValuesIn(scene_matrix()), scene_name);

TEST(WholeFragments, AreAllPrimitivesInOrder) {
    EXPECT_TRUE(whole_fragments(TriangleMeshView()).empty());
    const TriangleMesh mesh = make_soup(40'000, 0.1F, 1);  // several chunks
    const TriangleMeshView view = mesh.view();
    const std::vector<Fragment> fragments = whole_fragments(view);
    ASSERT_EQ(fragments.size(), 40'000U);
    for (std::uint32_t id = 0; id < view.size(); ++id) {
        ASSERT_EQ(fragments[id].id, id);
        ASSERT_EQ(fragments[id].box, view.bounds(id));
    }
}

TEST(BoundsOfAll, HoldsAll) {
    EXPECT_EQ(bounds_of_all(TriangleMeshView()), Aabb{});
    EXPECT_EQ(bounds_of_all(BoxSet({at(0, 1), at(5, 7)})), at(0, 7));
}

}  // namespace
}  // namespace coppice::test
