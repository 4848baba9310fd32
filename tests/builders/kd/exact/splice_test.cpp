// Classification and splicing together: the children are as if made anew.

#include "builders/kd/exact/splice.h"

#include "builders/kd/exact/classify.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/scene_matrix.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

class SpliceScene : public testing::TestWithParam<NamedScene> {};

TEST_P(SpliceScene, GivesTheChildrenAllTheirEvents) {
    const TriangleMesh mesh = GetParam().make();
    const TriangleMeshView view = mesh.view();
    if (view.size() == 0) return;
    Random random(8);
    const Division division{view, Clipping::perfect};
    for (int round = 0; round < 10; ++round) {
        const std::vector<PrimRef> prim_refs = whole_prim_refs(view);
        const auto axis = static_cast<Axis>(random.below(3));
        const Aabb& any = prim_refs[random.below(view.size())].box;
        const SplitPlane plane{axis, round % 2 == 0
                                         ? any.lower[axis]
                                         : random.uniform(any.lower[axis], any.upper[axis])};
        const PlanarSide side = round % 3 == 0 ? PlanarSide::above : PlanarSide::below;

        ExactNode node = make_exact_node(prim_refs);
        Partition sides;
        const Classification classification = classify(node, plane, side, division, sides);
        const ExactChildren children = splice(std::move(node), classification, std::move(sides));

        const Partition expected = partition(prim_refs, plane, side, division);
        const ExactNode below = make_exact_node(expected.below);
        const ExactNode above = make_exact_node(expected.above);
        EXPECT_EQ(children.below.events, below.events);
        EXPECT_EQ(children.above.events, above.events);
        EXPECT_EQ(children.below.prim_refs.size(), below.prim_refs.size());
        EXPECT_EQ(children.above.prim_refs.size(), above.prim_refs.size());
    }
}

INSTANTIATE_TEST_SUITE_P(Seed8, SpliceScene, testing::ValuesIn(scene_matrix()), scene_name);

}  // namespace
}  // namespace coppice::test
