#include "coppice/tree/validate.h"

#include "support/tree_checks.h"
#include "tree/small_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace coppice::test {
namespace {

using testing::Each;
using testing::Field;
using testing::IsEmpty;
using testing::Not;

// Findings are of one kind and about one node, reference or primitive, and say something.
auto are_all(ValidationIssueKind kind, std::uint64_t subject) {
    return testing::AllOf(Not(IsEmpty()),
                          Each(testing::AllOf(Field(&ValidationIssue::kind, kind),
                                              Field(&ValidationIssue::subject, subject),
                                              Field(&ValidationIssue::message, Not(IsEmpty())))));
}

std::vector<ValidationIssue> findings_in(const TreeParts& parts) {
    return validate(parts.tree(), five_boxes());
}

TEST(Validate, FindsNothingInASoundTree) {
    EXPECT_THAT(findings_in(parts_over_five_boxes()), IsEmpty());
    EXPECT_THAT(validate(KdTree{}, BoxSet({})), IsEmpty());
    EXPECT_THAT(validate({{KdNode::make_leaf(0, 1)}, {0}, box_at(0)}, BoxSet({box_at(0)})),
                IsEmpty());
}

TEST(Validate, AcceptsEmptyLeaves) {
    TreeParts parts = parts_over_five_boxes();
    parts.nodes[3] = inner_node(Axis::y, 0.5F, 7);
    parts.nodes.push_back(KdNode::make_leaf(0, 2));
    parts.nodes.push_back(KdNode::make_leaf(6, 0));
    BoxSet boxes({{{0, 0, 0}, {1, 0.4F, 1}},
                  box_at(2),
                  box_at(4),
                  box_at(6),
                  {{0.5F, 0, 0}, {2.5F, 0.4F, 1}}});
    EXPECT_THAT(validate(parts.tree(), boxes), IsEmpty());
}

TEST(Validate, FindsBadChildren) {
    for (const std::uint32_t child : {0U, 1U, 6U, 7U, 1000U, KdNode::max_payload}) {
        TreeParts parts = parts_over_five_boxes();
        parts.nodes[1] = inner_node(Axis::x, 1.5F, child);
        const auto findings = findings_in(parts);
        ASSERT_THAT(findings, Not(IsEmpty()));
        EXPECT_EQ(findings[0].kind, ValidationIssueKind::bad_child);
        EXPECT_EQ(findings[0].subject, 1U);
    }
}

TEST(Validate, FindsSharedChildren) {
    for (const std::uint32_t child : {3U, 4U}) {  // one or both of another's
        TreeParts parts = parts_over_five_boxes();
        parts.nodes[2] = inner_node(Axis::x, 5.5F, child);
        const auto findings = findings_in(parts);
        ASSERT_THAT(findings, Not(IsEmpty()));
        EXPECT_EQ(findings[0].kind, ValidationIssueKind::bad_child);
        EXPECT_EQ(findings[0].subject, 2U);
    }
}

TEST(Validate, FindsARootThatIsItsOwnChild) {
    const KdTree tree({inner_node(Axis::x, 0.5F, 0), KdNode{}}, {}, box_at(0));
    const auto findings = validate(tree, BoxSet({}));
    ASSERT_THAT(findings, Not(IsEmpty()));
    EXPECT_EQ(findings[0].kind, ValidationIssueKind::bad_child);
}

TEST(Validate, FindsUnreachableNodes) {
    TreeParts parts = parts_over_five_boxes();
    parts.nodes.push_back(KdNode{});
    EXPECT_THAT(findings_in(parts), are_all(ValidationIssueKind::unreachable_node, 7));
    parts = {{KdNode{}, KdNode{}}, {}, {}};
    EXPECT_THAT(validate(parts.tree(), BoxSet({})),
                are_all(ValidationIssueKind::unreachable_node, 1));
}

// A tree whose lower children are split `depth` times, over nothing.
KdTree chain_of(int depth) {
    std::vector<KdNode> nodes{KdNode{}};
    std::size_t lowest = 0;
    for (int level = 0; level < depth; ++level) {
        const float position = 1.0F - static_cast<float>(level + 1) / static_cast<float>(depth + 1);
        nodes[lowest] = inner_node(Axis::x, position, static_cast<std::uint32_t>(nodes.size()));
        lowest = nodes.size();
        nodes.resize(nodes.size() + 2);
    }
    return {std::move(nodes), {}, box_at(0)};
}

TEST(Validate, FindsTreesTooDeep) {
    EXPECT_THAT(validate(chain_of(KdTree::max_depth), BoxSet({})), IsEmpty());
    constexpr std::uint64_t first_too_deep = 2 * KdTree::max_depth + 1;
    EXPECT_THAT(validate(chain_of(KdTree::max_depth + 1), BoxSet({})),
                are_all(ValidationIssueKind::too_deep, first_too_deep));
    EXPECT_THAT(validate(chain_of(100'000), BoxSet({})),
                are_all(ValidationIssueKind::too_deep, first_too_deep));
}

TEST(Validate, FindsPlanesOutside) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const float position :
         {-1.0F, 0.0F, 3.5F, 4.0F, infinity, -infinity, std::numeric_limits<float>::quiet_NaN()}) {
        TreeParts parts = parts_over_five_boxes();
        parts.nodes[1] = inner_node(Axis::x, position, 3);
        EXPECT_THAT(findings_in(parts), are_all(ValidationIssueKind::plane_outside, 1)) << position;
    }
    for (const float position : {0.0F, 1.0F}) {
        TreeParts parts = parts_over_five_boxes();
        parts.nodes[0] = inner_node(Axis::z, position, 1);
        EXPECT_THAT(findings_in(parts), are_all(ValidationIssueKind::plane_outside, 0)) << position;
    }
}

TEST(Validate, FindsPlanesInAnEmptyBox) {
    const KdTree tree({inner_node(Axis::x, 0.0F, 1), KdNode{}, KdNode{}}, {}, {});
    EXPECT_THAT(validate(tree, BoxSet({})), are_all(ValidationIssueKind::plane_outside, 0));
}

TEST(Validate, FindsRangesBehindTheReferences) {
    TreeParts parts = parts_over_five_boxes();
    parts.nodes[6] = KdNode::make_leaf(5, 2);
    const auto findings = findings_in(parts);
    ASSERT_THAT(findings, Not(IsEmpty()));
    EXPECT_EQ(findings[0].kind, ValidationIssueKind::bad_range);
    EXPECT_EQ(findings[0].subject, 6U);
    for (const std::uint32_t first : {6U, 0xffffffffU}) {
        parts.nodes[6] = KdNode::make_leaf(first, KdNode::max_payload);
        EXPECT_EQ(findings_in(parts).at(0).kind, ValidationIssueKind::bad_range);
    }
}

TEST(Validate, FindsOverlappingRanges) {
    TreeParts parts = parts_over_five_boxes();
    parts.nodes[4] = KdNode::make_leaf(1, 3);
    EXPECT_EQ(findings_in(parts).at(0).kind, ValidationIssueKind::bad_range);
    EXPECT_EQ(findings_in(parts).at(0).subject, 4U);
    parts = parts_over_five_boxes();
    parts.nodes[4] = KdNode::make_leaf(2, 3);
    parts.references = {0, 4, 1, 2, 3, 4};
    EXPECT_THAT(findings_in(parts), are_all(ValidationIssueKind::bad_range, 5));
}

TEST(Validate, FindsUnreachableReferences) {
    TreeParts parts = parts_over_five_boxes();
    parts.references.push_back(3);
    EXPECT_THAT(findings_in(parts), are_all(ValidationIssueKind::unreachable_reference, 6));
}

TEST(Validate, FindsReferencesToNothing) {
    for (const std::uint32_t id : {5U, 0xffffffffU}) {
        TreeParts parts = parts_over_five_boxes();
        parts.references[5] = id;
        EXPECT_THAT(findings_in(parts), are_all(ValidationIssueKind::bad_reference, 6));
    }
}

TEST(Validate, FindsUnsortedAndRepeatedReferences) {
    TreeParts parts = parts_over_five_boxes();
    std::swap(parts.references[0], parts.references[1]);
    EXPECT_THAT(findings_in(parts), are_all(ValidationIssueKind::unsorted_references, 3));
    parts.references[0] = parts.references[1] = 4;
    EXPECT_THAT(findings_in(parts), are_all(ValidationIssueKind::unsorted_references, 3));
}

TEST(Validate, FindsMissingReferences) {
    TreeParts parts = parts_over_five_boxes();  // box 4 is in two leaves; leave it out of one
    parts.nodes[3] = KdNode::make_leaf(0, 1);
    parts.nodes[4] = KdNode::make_leaf(1, 2);
    parts.nodes[5] = KdNode::make_leaf(3, 1);
    parts.nodes[6] = KdNode::make_leaf(4, 1);
    parts.references = {0, 1, 4, 2, 3};
    EXPECT_THAT(findings_in(parts), are_all(ValidationIssueKind::missing_reference, 3));
}

TEST(Validate, ForgivesMissingReferencesWithinRounding) {
    const auto findings_for_reach = [](float reach) {
        BoxSet boxes({box_at(0, 1.0F + reach), box_at(1.0F)});
        const KdTree tree(
            {inner_node(Axis::x, 1.0F, 1), KdNode::make_leaf(0, 1), KdNode::make_leaf(1, 1)},
            {0, 1}, box_at(0, 2));
        return validate(tree, boxes);
    };
    EXPECT_THAT(findings_for_reach(0.0F), IsEmpty());
    EXPECT_THAT(findings_for_reach(1e-7F), IsEmpty());
    EXPECT_THAT(findings_for_reach(1e-4F), are_all(ValidationIssueKind::missing_reference, 2));
}

TEST(Validate, FindsStrayReferences) {
    TreeParts parts = parts_over_five_boxes();
    parts.nodes[6] = KdNode::make_leaf(5, 2);
    parts.references = {0, 4, 1, 4, 2, 0, 3};
    EXPECT_THAT(findings_in(parts), are_all(ValidationIssueKind::stray_reference, 6));
}

TEST(Validate, AcceptsReferencesOfWhatOnlyTouches) {
    const BoxSet boxes({box_at(0), box_at(1)});
    const KdTree tree(
        {inner_node(Axis::x, 1.0F, 1), KdNode::make_leaf(0, 2), KdNode::make_leaf(2, 2)},
        {0, 1, 0, 1}, box_at(0, 2));
    EXPECT_THAT(validate(tree, boxes), IsEmpty());
}

TEST(Validate, FindsLostPrimitives) {
    // A primitive that lies in a plane belongs to either side, but not to none.
    std::vector<Aabb> boxes;
    for (std::uint32_t id = 0; id < 5; ++id) {
        boxes.push_back(five_boxes().bounds(id));
    }
    boxes.push_back(box_at(3.5F, 0));
    EXPECT_THAT(validate(parts_over_five_boxes().tree(), BoxSet(boxes)),
                are_all(ValidationIssueKind::lost_primitive, 5));
}

TEST(Validate, FindsLostPrimitivesInsideALeafToo) {
    TreeParts parts = parts_over_five_boxes();
    parts.nodes[6] = KdNode::make_leaf(5, 0);
    parts.references.pop_back();
    const auto findings = findings_in(parts);
    ASSERT_EQ(findings.size(), 2U);
    EXPECT_EQ(findings[0].kind, ValidationIssueKind::lost_primitive);
    EXPECT_EQ(findings[0].subject, 3U);
    EXPECT_EQ(findings[1].kind, ValidationIssueKind::missing_reference);
    EXPECT_EQ(findings[1].subject, 6U);
}

TEST(Validate, FindsABoxTooSmall) {
    for (const Axis axis : all_axes) {
        TreeParts parts = parts_over_five_boxes();
        parts.bounds.upper[axis] = std::nextafter(parts.bounds.upper[axis], 0.0F);
        const auto findings = findings_in(parts);
        ASSERT_THAT(findings,
                    Each(Field(&ValidationIssue::kind, ValidationIssueKind::bounds_too_small)));
        EXPECT_EQ(findings.size(), axis == Axis::x ? 1U : 5U);
    }
    const auto of_empty_tree = validate(KdTree{}, BoxSet({box_at(0)}));
    EXPECT_THAT(of_empty_tree, testing::Contains(Field(&ValidationIssue::kind,
                                                       ValidationIssueKind::lost_primitive)));
    EXPECT_THAT(of_empty_tree, testing::Contains(Field(&ValidationIssue::kind,
                                                       ValidationIssueKind::bounds_too_small)));
}

TEST(Validate, StopsAtItsLimit) {
    const KdTree tree;
    const BoxSet boxes(std::vector<Aabb>(1000, box_at(0)));
    EXPECT_EQ(validate(tree, boxes).size(), 100U);
    EXPECT_EQ(validate(tree, boxes, 7).size(), 7U);
    EXPECT_EQ(validate(tree, boxes, 5000).size(), 2000U);
}

TEST(Validate, SurvivesAnyNodes) {
    Random random(1);
    const BoxSet boxes = five_boxes();
    for (int i = 0; i < 20'000; ++i) {
        TreeParts parts = parts_over_five_boxes();
        for (std::uint32_t change = random.below(4); change < 4; ++change) {
            KdNode& node = parts.nodes[random.below(7)];
            if (random.below(2) == 0) {
                node = inner_node(static_cast<Axis>(random.below(3)), random.uniform(-1, 8),
                                  random.below(9));
            } else {
                node = KdNode::make_leaf(random.below(8), random.below(4));
            }
            parts.references[random.below(6)] = random.below(6);
        }
        EXPECT_LE(validate(parts.tree(), boxes).size(), 100U);
    }
}

TEST(FindingName, IsTheEnumerators) {
    EXPECT_STREQ(name_of(ValidationIssueKind::bad_child), "bad_child");
    EXPECT_STREQ(name_of(ValidationIssueKind::unreachable_node), "unreachable_node");
    EXPECT_STREQ(name_of(ValidationIssueKind::too_deep), "too_deep");
    EXPECT_STREQ(name_of(ValidationIssueKind::plane_outside), "plane_outside");
    EXPECT_STREQ(name_of(ValidationIssueKind::bad_range), "bad_range");
    EXPECT_STREQ(name_of(ValidationIssueKind::unreachable_reference), "unreachable_reference");
    EXPECT_STREQ(name_of(ValidationIssueKind::bad_reference), "bad_reference");
    EXPECT_STREQ(name_of(ValidationIssueKind::unsorted_references), "unsorted_references");
    EXPECT_STREQ(name_of(ValidationIssueKind::missing_reference), "missing_reference");
    EXPECT_STREQ(name_of(ValidationIssueKind::stray_reference), "stray_reference");
    EXPECT_STREQ(name_of(ValidationIssueKind::lost_primitive), "lost_primitive");
    EXPECT_STREQ(name_of(ValidationIssueKind::bounds_too_small), "bounds_too_small");
    EXPECT_STREQ(name_of(static_cast<ValidationIssueKind>(99)), "unknown");
}

}  // namespace
}  // namespace coppice::test
