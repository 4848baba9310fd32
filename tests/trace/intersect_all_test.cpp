// All hits in order, and how many there are, of k-d trees against brute force.

#include "coppice/builders/build_tree.h"
#include "coppice/geom/triangle.h"
#include "coppice/trace/brute_force.h"
#include "coppice/trace/intersect.h"

#include "support/meshes.h"
#include "support/rays.h"
#include "support/scene_matrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace coppice::test {
namespace {

// By the definition, with nothing of the library but the test of one triangle.
std::vector<Hit> sorted_hits(TriangleMeshView mesh, const Ray& ray) {
    std::vector<Hit> hits;
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        auto hit = intersect_triangle(ray, mesh.triangle(id));
        if (!hit) continue;
        hit->prim = id;
        hits.push_back(*hit);
    }
    std::stable_sort(hits.begin(), hits.end(),
                     [](const Hit& a, const Hit& b) { return a.t < b.t; });
    return hits;
}

// All hits, `at_a_time` of them in each call of `find(hits, after)`.
template <typename Find>
std::vector<Hit> gathered(std::size_t at_a_time, Find&& find) {
    std::vector<Hit> hits;
    std::vector<Hit> some(at_a_time);
    for (std::size_t found = at_a_time; found == at_a_time;) {
        found = find(std::span<Hit>(some), hits.empty() ? nullptr : &hits.back());
        hits.insert(hits.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(found));
    }
    return hits;
}

class IntersectAllScene : public testing::TestWithParam<NamedScene> {};

// As the tree and brute force find them, in pieces of any size.
void expect_hits(const KdTree& tree, TriangleMeshView mesh, const Ray& ray) {
    const std::vector<Hit> expected = sorted_hits(mesh, ray);
    ASSERT_EQ(count_hits(tree, mesh, ray), expected.size());
    ASSERT_EQ(brute_force_count_hits(mesh, ray), expected.size());
    for (const std::size_t at_a_time : {3U, 100U}) {
        if (expected.size() > 300 * at_a_time) continue;
        const auto found = gathered(at_a_time, [&](std::span<Hit> hits, const Hit* after) {
            return intersect_all(tree, mesh, ray, hits, after);
        });
        ASSERT_EQ(found, expected);
    }
    const auto by_force = gathered(1000, [&](std::span<Hit> hits, const Hit* after) {
        return brute_force_intersect_all(mesh, ray, hits, after);
    });
    ASSERT_EQ(by_force, expected);
}

TEST_P(IntersectAllScene, EqualsBruteForceInPiecesOfAnySize) {
    const TriangleMesh mesh = GetParam().make();
    const KdTree tree = build_kd_tree(mesh.view(), {.sample = {.rate = 0.3}}).tree;
    RaySource rays(mesh, tree, 23);
    for (const RayKind kind : all_ray_kinds) {
        for (int i = 0; i < 6; ++i) {
            SCOPED_TRACE(testing::Message() << name_of(kind) << " " << i);
            expect_hits(tree, mesh.view(), rays.next(kind));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seed23, IntersectAllScene, testing::ValuesIn(scene_matrix()), scene_name);

// Sheets at z = 1 to 4, hit by a ray up the z axis, each in both triangles' common edge.
class Sheets : public testing::Test {
protected:
    Sheets() {
        for (const float z : {4.0F, 2.0F, 1.0F, 3.0F}) {
            mesh_ = joined(std::move(mesh_), make_sheet(1, {-1, -1, z}, {2, 0, 0}, {0, 2, 0}));
        }
        tree_ = build_kd_tree(mesh_.view()).tree;
    }

    TriangleMesh mesh_;
    KdTree tree_;
    Ray up_{{0, 0, 0}, {0, 0, 1}};
};

TEST_F(Sheets, AreHitInOrderOfDistanceThenId) {
    std::array<Hit, 8> hits;
    ASSERT_EQ(intersect_all(tree_, mesh_.view(), up_, hits), 8U);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const std::size_t sheet = i / 2;
        EXPECT_EQ(hits[i].t, 1.0F + static_cast<float>(sheet));
        if (i % 2 == 1) {
            EXPECT_EQ(hits[i].prim, hits[i - 1].prim + 1);
        }
    }
    EXPECT_EQ(intersect_all(tree_, mesh_.view(), up_, hits, &hits[7]), 0U);
    EXPECT_EQ(intersect_all(tree_, mesh_.view(), up_, hits, &hits[4]), 3U);
    EXPECT_EQ(hits[0].t, 3.0F) << "the second triangle of that sheet";
}

TEST_F(Sheets, AreHitWithinTheLimits) {
    std::array<Hit, 8> hits;
    EXPECT_EQ(intersect_all(tree_, mesh_.view(), {{0, 0, 0}, {0, 0, 1}, 2.0F, 3.0F}, hits), 4U);
    EXPECT_EQ(count_hits(tree_, mesh_.view(), {{0, 0, 0}, {0, 0, 1}, 2.0F, 3.0F}), 4U);
    EXPECT_EQ(intersect_all(tree_, mesh_.view(), {{0, 0, 2}, {0, 0, -1}, -9.0F, 0.0F}, hits), 6U);
    EXPECT_EQ(hits[0].t, -2.0F);
}

TEST_F(Sheets, AreNotHitByBadRaysNorWithoutRoom) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    std::array<Hit, 2> hits;
    EXPECT_EQ(intersect_all(tree_, mesh_.view(), up_, {}), 0U);
    EXPECT_EQ(brute_force_intersect_all(mesh_.view(), up_, {}), 0U);
    for (const Ray& bad : {Ray{{0, 0, 0}, {0, 0, 0}}, Ray{{0, 0, nan}, {0, 0, 1}},
                           Ray{{0, 0, 0}, {0, 0, 1}, 3, 1}, Ray{{0, 0, 0}, {0, 0, 1}, nan}}) {
        EXPECT_EQ(intersect_all(tree_, mesh_.view(), bad, hits), 0U);
        EXPECT_EQ(brute_force_intersect_all(mesh_.view(), bad, hits), 0U);
        EXPECT_EQ(count_hits(tree_, mesh_.view(), bad), 0U);
        EXPECT_EQ(brute_force_count_hits(mesh_.view(), bad), 0U);
    }
}

TEST_F(Sheets, AreCountedAsTheyAreVisited) {
    TraversalCounts counts;
    ASSERT_TRUE(intersect(tree_, mesh_.view(), up_, counts).has_value());
    EXPECT_GE(counts.leaves, 1U);
    EXPECT_GE(counts.primitives, 2U);
    TraversalCounts more = counts;
    ASSERT_TRUE(occluded(tree_, mesh_.view(), up_, more));
    EXPECT_GT(more.leaves, counts.leaves) << "counts are added up";
    TraversalCounts none;
    EXPECT_FALSE(occluded(tree_, mesh_.view(), {{9, 9, 9}, {0, 0, 1}}, none));
    EXPECT_EQ(none, TraversalCounts()) << "beside the box";
}

}  // namespace
}  // namespace coppice::test
