#include "coppice/tree/wide_bvh.h"

#include "coppice/base/error.h"
#include "coppice/build/build_tree.h"
#include "coppice/cost/measure.h"
#include "coppice/tree/validate.h"

#include "support/meshes.h"
#include "support/tree_checks.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

namespace coppice::test {
namespace {

TEST(WideChild, KeepsWhatItIsMadeOf) {
    EXPECT_TRUE(WideChild::make_empty().is_empty());
    EXPECT_FALSE(WideChild::make_empty().is_leaf());
    for (const std::uint32_t index : {0U, 77U, WideChild::max_node_index}) {
        const WideChild child = WideChild::make_inner(index);
        EXPECT_FALSE(child.is_empty());
        EXPECT_FALSE(child.is_leaf());
        EXPECT_EQ(child.node(), index);
    }
    for (const std::uint32_t first : {0U, 77U, WideChild::max_block_index}) {
        for (const std::uint32_t count : {1U, 2U, WideChild::max_block_count}) {
            const WideChild child = WideChild::make_leaf(first, count);
            EXPECT_FALSE(child.is_empty());
            EXPECT_TRUE(child.is_leaf());
            EXPECT_EQ(child.first_block(), first);
            EXPECT_EQ(child.block_count(), count);
        }
    }
}

TEST(WideBvh, NeedsARoot) {
    EXPECT_THROW(WideBvh(nullptr, {}, {}, {}), Error);
    EXPECT_EQ(WideBvh().nodes().size(), 1U);
    EXPECT_TRUE(is_sound(WideBvh(), TriangleMeshView()));
}

TEST(MeasureWide, CountsABlockAsOneTest) {
    const TriangleMesh mesh = make_sheet(2, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});  // 8 triangles
    const TreeStatistics statistics = measure(build_wide_bvh(mesh.view()), {});
    EXPECT_EQ(statistics.inner_count, 1U);
    EXPECT_EQ(statistics.leaf_count, 1U);
    EXPECT_EQ(statistics.reference_count, 8U);
    EXPECT_DOUBLE_EQ(statistics.expected_inner_visits, 1.0);
    EXPECT_DOUBLE_EQ(statistics.expected_primitive_tests, 1.0);
    EXPECT_DOUBLE_EQ(statistics.sah_cost, 2.0);
}

// A tree whose arrays a test may spoil.
class SpoiledTree {
public:
    explicit SpoiledTree(const TriangleMesh& mesh) : mesh_(mesh) {
        const WideBvh tree = build_wide_bvh(mesh.view());
        nodes.assign(tree.nodes().begin(), tree.nodes().end());
        blocks.assign(tree.blocks().begin(), tree.blocks().end());
        bounds_ = tree.bounds();
    }

    [[nodiscard]] bool has(FindingKind kind) const {
        const auto findings =
            validate(WideBvh(nullptr, nodes, blocks, bounds_), mesh_.view(), 1000);
        return std::any_of(findings.begin(), findings.end(),
                           [&](const Finding& finding) { return finding.kind == kind; });
    }

    std::vector<WideNode> nodes;
    std::vector<TriangleBlock> blocks;

private:
    const TriangleMesh& mesh_;
    Aabb bounds_;
};

TEST(ValidateWide, FindsWhatIsWrong) {
    const TriangleMesh mesh = make_sphere(12, 13);

    struct Case {
        FindingKind kind;
        std::function<void(SpoiledTree&)> spoil;
    };

    const std::vector<Case> cases{
        {FindingKind::bad_child,
         [](SpoiledTree& tree) { tree.nodes[0].child[0] = WideChild::make_inner(0); }},
        {FindingKind::unreachable_node,
         [](SpoiledTree& tree) { tree.nodes.push_back(make_empty_wide_node()); }},
        {FindingKind::unreachable_reference,
         [](SpoiledTree& tree) { tree.blocks.push_back(tree.blocks[0]); }},
        {FindingKind::bad_range,
         [](SpoiledTree& tree) { tree.nodes[0].child[7] = WideChild::make_leaf(99'999, 1); }},
        {FindingKind::bad_reference, [](SpoiledTree& tree) { tree.blocks[0].id[0] = 5000; }},
        {FindingKind::wrong_corners,
         [](SpoiledTree& tree) { tree.blocks[0].corner[1][2][0] += 0.5F; }},
        {FindingKind::box_outside, [](SpoiledTree& tree) { tree.nodes[1].bound[3][0] += 5.0F; }},
        {FindingKind::lost_primitive,
         [](SpoiledTree& tree) { tree.blocks[0].id[0] = TriangleBlock::no_triangle; }}};
    ASSERT_GT(SpoiledTree(mesh).nodes.size(), 1U);
    for (const Case& each : cases) {
        SpoiledTree tree(mesh);
        EXPECT_FALSE(tree.has(each.kind));
        each.spoil(tree);
        EXPECT_TRUE(tree.has(each.kind)) << finding_name(each.kind);
    }
}

}  // namespace
}  // namespace coppice::test
