#include "builders/kd/partition.h"

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

std::vector<std::uint32_t> ids_of(const std::vector<PrimRef>& prim_refs) {
    std::vector<std::uint32_t> ids;
    for (const PrimRef& prim_ref : prim_refs) {
        ids.push_back(prim_ref.id);
    }
    return ids;
}

TEST(RelationTo, TellsTouchingFromCrossing) {
    constexpr SplitPlane plane{Axis::x, 2.0F};
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
    const std::vector<PrimRef> prim_refs = whole_prim_refs(boxes);
    const SplitPlane plane{Axis::x, 2.0F};
    for (const Clipping clipping : {Clipping::perfect, Clipping::bounding_box}) {
        const Partition low = partition(prim_refs, plane, PlanarSide::below, {boxes, clipping});
        EXPECT_THAT(ids_of(low.below), ElementsAre(0, 1, 2, 4, 5));
        EXPECT_THAT(ids_of(low.above), ElementsAre(2, 3, 6));
        const Partition high = partition(prim_refs, plane, PlanarSide::above, {boxes, clipping});
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
    const std::vector<PrimRef> prim_refs = whole_prim_refs(view);
    const SplitPlane plane{Axis::x, 1.0F};
    const Partition perfect =
        partition(prim_refs, plane, PlanarSide::below, {view, Clipping::perfect});
    EXPECT_FLOAT_EQ(perfect.above.at(0).box.upper.y, 1.0F);
    EXPECT_EQ(perfect.below.at(0).box.upper.y, 2.0F);
    const Partition plain =
        partition(prim_refs, plane, PlanarSide::below, {view, Clipping::bounding_box});
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
    const Partition sides = partition(whole_prim_refs(set), {Axis::x, 1.0F}, PlanarSide::below,
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
    const std::vector<PrimRef> prim_refs = whole_prim_refs(view);
    if (prim_refs.empty()) return;
    Random random(21);
    for (int round = 0; round < 30; ++round) {
        const auto axis = static_cast<Axis>(random.below(3));
        const PrimRef& any = prim_refs[random.below(view.size())];
        const SplitPlane plane{
            axis, round % 3 == 0 ? any.box.lower[axis]
                                 : random.uniform(any.box.lower[axis], any.box.upper[axis])};
        for (const Clipping clipping : {Clipping::perfect, Clipping::bounding_box}) {
            const Partition sides =
                partition(prim_refs, plane, PlanarSide::above, {view, clipping});
            std::vector<bool> is_seen(prim_refs.size(), false);
            for (const PrimRef& prim_ref : sides.below) {
                is_seen[prim_ref.id] = true;
                const Aabb limits = below(prim_refs[prim_ref.id].box, plane);
                EXPECT_TRUE(prim_ref.box == prim_refs[prim_ref.id].box ||
                            intersection(prim_ref.box, limits) == prim_ref.box);
                EXPECT_LE(prim_ref.box.upper[axis], plane.position);
            }
            for (const PrimRef& prim_ref : sides.above) {
                is_seen[prim_ref.id] = true;
                EXPECT_GE(prim_ref.box.lower[axis], plane.position);
            }
            EXPECT_TRUE(
                std::all_of(is_seen.begin(), is_seen.end(), [](bool seen) { return seen; }));
            EXPECT_EQ(intersection(bounds_of_all(view), bounds_of(mesh.vertices)),
                      bounds_of_all(view));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seed21, PartitionScene, testing::ValuesIn(scene_matrix()), scene_name);

TEST(WholePrimRefs, AreAllPrimitivesInOrder) {
    EXPECT_TRUE(whole_prim_refs(TriangleMeshView()).empty());
    const TriangleMesh mesh = make_soup(40'000, 0.1F, 1);  // several chunks
    const TriangleMeshView view = mesh.view();
    const std::vector<PrimRef> prim_refs = whole_prim_refs(view);
    ASSERT_EQ(prim_refs.size(), 40'000U);
    for (std::uint32_t id = 0; id < view.size(); ++id) {
        ASSERT_EQ(prim_refs[id].id, id);
        ASSERT_EQ(prim_refs[id].box, view.bounds(id));
    }
}

TEST(BoundsOfAll, HoldsAll) {
    EXPECT_EQ(bounds_of_all(TriangleMeshView()), Aabb{});
    EXPECT_EQ(bounds_of_all(BoxSet({at(0, 1), at(5, 7)})), at(0, 7));
}

}  // namespace
}  // namespace coppice::test
