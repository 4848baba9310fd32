#include "coppice/tree/bvh8.h"

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
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

TEST(Bvh8Child, KeepsWhatItIsMadeOf) {
    EXPECT_TRUE(Bvh8Child::make_empty().is_empty());
    EXPECT_FALSE(Bvh8Child::make_empty().is_leaf());
    for (const std::uint32_t index : {0U, 77U, Bvh8Child::max_node_index}) {
        const Bvh8Child child = Bvh8Child::make_inner(index);
        EXPECT_FALSE(child.is_empty());
        EXPECT_FALSE(child.is_leaf());
        EXPECT_EQ(child.node(), index);
    }
    for (const std::uint32_t first : {0U, 77U, Bvh8Child::max_block_index}) {
        for (const std::uint32_t count : {1U, 2U, Bvh8Child::max_block_count}) {
            const Bvh8Child child = Bvh8Child::make_leaf(first, count);
            EXPECT_FALSE(child.is_empty());
            EXPECT_TRUE(child.is_leaf());
            EXPECT_EQ(child.first_block(), first);
            EXPECT_EQ(child.block_count(), count);
        }
    }
}

TEST(Bvh8, NeedsARoot) {
    EXPECT_THROW(Bvh8(nullptr, {}, {}, {}), Error);
    EXPECT_EQ(Bvh8().nodes().size(), 1U);
    EXPECT_TRUE(is_sound(Bvh8(), TriangleMeshView()));
}

TEST(MeasureBvh8, CountsABlockAsOneTest) {
    const TriangleMesh mesh = make_sheet(2, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});  // 8 triangles
    const TreeStatistics statistics = measure(build_bvh8(mesh.view()).tree, {});
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
        const Bvh8 tree = build_bvh8(mesh.view()).tree;
        nodes.assign(tree.nodes().begin(), tree.nodes().end());
        blocks.assign(tree.blocks().begin(), tree.blocks().end());
        bounds_ = tree.bounds();
    }

    [[nodiscard]] bool has(ValidationIssueKind kind) const {
        const auto findings = validate(Bvh8(nullptr, nodes, blocks, bounds_), mesh_.view(), 1000);
        return std::any_of(findings.begin(), findings.end(),
                           [&](const ValidationIssue& finding) { return finding.kind == kind; });
    }

    std::vector<Bvh8Node> nodes;
    std::vector<TriangleBlock> blocks;

private:
    const TriangleMesh& mesh_;
    Aabb bounds_;
};

TEST(ValidateBvh8, FindsWhatIsWrong) {
    const TriangleMesh mesh = make_sphere(12, 13);

    struct Case {
        ValidationIssueKind kind;
        std::function<void(SpoiledTree&)> spoil;
    };

    const std::vector<Case> cases{
        {ValidationIssueKind::bad_child,
         [](SpoiledTree& tree) { tree.nodes[0].child[0] = Bvh8Child::make_inner(0); }},
        {ValidationIssueKind::unreachable_node,
         [](SpoiledTree& tree) { tree.nodes.push_back(make_empty_bvh8_node()); }},
        {ValidationIssueKind::unreachable_reference,
         [](SpoiledTree& tree) { tree.blocks.push_back(tree.blocks[0]); }},
        {ValidationIssueKind::bad_range,
         [](SpoiledTree& tree) { tree.nodes[0].child[7] = Bvh8Child::make_leaf(99'999, 1); }},
        {ValidationIssueKind::bad_gap,
         [](SpoiledTree& tree) { tree.nodes[0].child[0] = Bvh8Child::make_empty(); }},
        {ValidationIssueKind::bad_reference,
         [](SpoiledTree& tree) { tree.blocks[0].id[0] = 5000; }},
        {ValidationIssueKind::wrong_corners,
         [](SpoiledTree& tree) { tree.blocks[0].corner[1][2][0] += 0.5F; }},
        {ValidationIssueKind::box_outside,
         [](SpoiledTree& tree) { tree.nodes[1].bound[3][0] += 5.0F; }},
        {ValidationIssueKind::lost_primitive,
         [](SpoiledTree& tree) { tree.blocks[0].id[0] = TriangleBlock::no_triangle; }}};
    ASSERT_GT(SpoiledTree(mesh).nodes.size(), 1U);
    for (const Case& each : cases) {
        SpoiledTree tree(mesh);
        EXPECT_FALSE(tree.has(each.kind));
        each.spoil(tree);
        EXPECT_TRUE(tree.has(each.kind)) << name_of(each.kind);
    }
}

}  // namespace
}  // namespace coppice::test
