// A sound tree deeper than any that is built overran the traversal's stack. Such trees are findings
// now: see Validate.FindsTreesTooDeep. The deepest one allowed has to trace.

#include "coppice/trace/brute_force.h"
#include "coppice/trace/intersect.h"
#include "coppice/tree/validate.h"

#include "support/meshes.h"
#include "support/rays.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

// One triangle in every leaf of a chain of planes across x, lower children split on.
KdTree make_chain(int depth, bool split_upper) {
    std::vector<KdNode> nodes{KdNode{}};
    std::size_t last = 0;
    for (int level = 0; level < depth; ++level) {
        const float share = static_cast<float>(level + 1) / static_cast<float>(depth + 1);
        const auto child = static_cast<std::uint32_t>(nodes.size());
        nodes[last] = KdNode::make_inner({Axis::x, split_upper ? share : 1.0F - share},
                                         PlanarSide::below, child);
        last = split_upper ? child + 1 : child;
        nodes.resize(nodes.size() + 2);
    }
    std::vector<std::uint32_t> references;
    for (KdNode& node : nodes) {
        if (!node.is_leaf()) continue;
        node = KdNode::make_leaf(static_cast<std::uint32_t>(references.size()), 1);
        references.push_back(0);
    }
    return {std::move(nodes), std::move(references), {{0, 0, 0}, {1, 1, 1}}};
}

TEST(DeepTree, Traces) {
    const TriangleMesh mesh = make_triangle({Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{0, 1, 1}});
    for (const bool split_upper : {false, true}) {
        const KdTree tree = make_chain(KdTree::max_depth, split_upper);
        ASSERT_TRUE(validate(tree, mesh.view()).empty());
        RaySource rays(mesh, tree, 3);
        for (int i = 0; i < 500; ++i) {
            for (const RayKind kind : all_ray_kinds) {
                const Ray ray = rays.next(kind);
                EXPECT_EQ(occluded(tree, mesh.view(), ray), brute_force_occluded(mesh.view(), ray));
            }
        }
    }
}

}  // namespace
}  // namespace coppice::test
