// The event builder against its naive twin: KdBuilder with the rule `exact`, plane for plane.

#include "builders/kd/exact/exact_builder.h"

#include "coppice/base/parallel.h"

#include "builders/kd/partition.h"
#include "support/meshes.h"
#include "support/primitives.h"
#include "support/scene_matrix.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

constexpr TerminationRule to_the_end{0, 1, 40, SplitSearch::until_it_pays, 8.0};
constexpr TerminationRule thesis{8, 3, 40, SplitSearch::first_offer, 0.0};

KdOptions exact_options(Clipping clipping, double empty_bonus) {
    return {.split = {.rule = "exact", .clipping = clipping}, .cost = {.empty_bonus = empty_bonus}};
}

void expect_same(std::vector<PrimRef> prim_refs, PrimitiveSetView primitives,
                 const KdOptions& options, const TerminationRule& stop) {
    const NodeState root{bounds_of_all(primitives)};
    const Subtree naive = assemble(KdBuilder(primitives, options, stop).build(prim_refs, root));
    const Subtree exact =
        assemble(ExactBuilder(primitives, options, stop).build(std::move(prim_refs), root));
    EXPECT_EQ(exact.nodes, naive.nodes);
    EXPECT_EQ(exact.references, naive.references);
}

class ExactBuilderScene : public testing::TestWithParam<NamedScene> {};

TEST_P(ExactBuilderScene, BuildsWhatTheNaiveBuilderDoes) {
    const Primitives scene(GetParam().make());
    for (const PrimitiveKind kind : {PrimitiveKind::triangles, PrimitiveKind::points}) {
        const PrimitiveSetView primitives = scene.of(kind);
        for (const Clipping clipping : {Clipping::perfect, Clipping::bounding_box}) {
            for (const TerminationRule& stop : {to_the_end, thesis}) {
                SCOPED_TRACE(name_of(clipping));
                expect_same(whole_prim_refs(primitives), primitives, exact_options(clipping, 0.2),
                            stop);
            }
        }
    }
}

TEST_P(ExactBuilderScene, CountsWeightsAsTheNaiveBuilderDoes) {
    const TriangleMesh mesh = GetParam().make();
    std::vector<PrimRef> prim_refs = whole_prim_refs(mesh.view());
    for (PrimRef& prim_ref : prim_refs) {
        prim_ref.weight = 1.0F + 0.25F * static_cast<float>(prim_ref.id % 7);
    }
    expect_same(prim_refs, mesh.view(), exact_options(Clipping::perfect, 0.5), to_the_end);
}

INSTANTIATE_TEST_SUITE_P(Matrix, ExactBuilderScene, testing::ValuesIn(scene_matrix()), scene_name);

TEST(ExactBuilder, IsTheSameForAnyThreads) {
    const TriangleMesh mesh = make_terrain(110, 2);  // large enough for parallel sweeps
    const TriangleMeshView view = mesh.view();
    const NodeState root{bounds_of_all(view)};
    const auto build = [&](int threads) {
        Subtree tree;
        run_with_threads(threads, [&] {
            tree = assemble(ExactBuilder(view, exact_options(Clipping::perfect, 0.2), to_the_end)
                                .build(whole_prim_refs(view), root));
        });
        return tree;
    };
    const Subtree expected = build(1);
    for (const int threads : {2, 3, 8}) {
        const Subtree tree = build(threads);
        EXPECT_TRUE(tree.nodes == expected.nodes) << threads;
        EXPECT_TRUE(tree.references == expected.references) << threads;
    }
}

}  // namespace
}  // namespace coppice::test
