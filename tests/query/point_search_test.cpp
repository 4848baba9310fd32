#include "coppice/query/point_search.h"

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/query/brute_force_search.h"

#include "query/query_points.h"
#include "support/meshes.h"
#include "support/numbers.h"
#include "support/scene_matrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace coppice::test {
namespace {

testing::AssertionResult are_same(const std::vector<Neighbor>& found,
                                  const std::vector<Neighbor>& expected) {
    for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i) {
        if (found[i].distance_squared == expected[i].distance_squared &&
            found[i].prim == expected[i].prim) {
            continue;
        }
        return testing::AssertionFailure()
               << "at " << i << ": " << found[i].prim << " at " << found[i].distance()
               << " instead of " << expected[i].prim << " at " << expected[i].distance();
    }
    if (found.size() == expected.size()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << found.size() << " instead of " << expected.size();
}

std::vector<Neighbor> first_of(const std::vector<Neighbor>& all, std::size_t count) {
    return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(count, all.size()))};
}

std::vector<Neighbor> find_k(const PointSearch& search, Vec3f at, std::size_t k,
                             float max_distance = infinity) {
    std::vector<Neighbor> found(k);
    found.resize(search.nearest_k(at, found, max_distance));
    return found;
}

std::vector<Neighbor> find_within(const PointSearch& search, Vec3f at, float radius) {
    std::vector<Neighbor> found;
    search.for_each_within(at, radius, [&](const Neighbor& f) { found.push_back(f); });
    std::sort(found.begin(), found.end(), [](const Neighbor& a, const Neighbor& b) {
        return std::tie(a.distance_squared, a.prim) < std::tie(b.distance_squared, b.prim);
    });
    return found;
}

std::vector<std::uint32_t> find_overlapping(const PointSearch& search, const Aabb& box) {
    std::vector<std::uint32_t> found;
    search.for_each_overlapping(box, [&](std::uint32_t id) { found.push_back(id); });
    std::sort(found.begin(), found.end());
    return found;
}

void check_near(const PointSearch& search, Vec3f at, const std::vector<Neighbor>& all) {
    const Neighbor one = search.nearest(at);
    ASSERT_TRUE(are_same(one.is_found() ? std::vector{one} : first_of(all, 0), first_of(all, 1)));
    ASSERT_TRUE(are_same(find_k(search, at, 9), first_of(all, 9)));
    if (all.empty()) return;
    const auto radius = static_cast<float>(all[all.size() / 7].distance());
    const auto beyond = std::find_if(all.begin(), all.end(), [&](const Neighbor& f) {
        return f.distance_squared > static_cast<double>(radius) * static_cast<double>(radius);
    });
    const std::vector within(all.begin(), beyond);
    ASSERT_TRUE(are_same(find_within(search, at, radius), within));
    ASSERT_TRUE(are_same(find_k(search, at, 2 * all.size(), radius), within));
}

class PointSearchScene : public testing::TestWithParam<NamedScene> {};

// The corners of a scene, those that stand in several places included.
TEST_P(PointSearchScene, EqualsBruteForce) {
    const TriangleMesh mesh = GetParam().make();
    const PointCloudView cloud(mesh.vertices);
    const std::vector<Vec3f> places = make_query_points(mesh.view(), 2, 43);
    for (const double rate : {1.0, 0.1}) {
        const KdTree tree = build_kd_tree(cloud, {.sample = {.rate = rate}}).tree;
        for (const Isa isa : available_isas()) {
            const PointSearch search(tree, cloud, isa);
            for (std::size_t i = 0; i < places.size(); ++i) {
                SCOPED_TRACE(i);
                check_near(search, places[i], brute_force_within(cloud, places[i]));
                Aabb box;
                box.grow(places[i]);
                EXPECT_EQ(find_overlapping(search, box), brute_force_overlapping(cloud, box));
                box.grow(places[i * i % places.size()]);
                EXPECT_EQ(find_overlapping(search, box), brute_force_overlapping(cloud, box));
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seed43, PointSearchScene, testing::ValuesIn(scene_matrix()), scene_name);

PointSearch search_of(const std::vector<Vec3f>& points) {
    return {build_kd_tree(PointCloudView(points)).tree, PointCloudView(points)};
}

TEST(PointSearch, FindsNothingNearNowhere) {
    const PointSearch search = search_of(make_sphere(10, 11).vertices);
    for (const Vec3f& bad : {Vec3f{nan, 0, 0}, Vec3f{0, nan, 0}, Vec3f{0, 0, infinity}}) {
        EXPECT_FALSE(search.nearest(bad).is_found());
        EXPECT_TRUE(find_k(search, bad, 3).empty());
        EXPECT_TRUE(find_within(search, bad, infinity).empty());
    }
    for (const float bad : {nan, -1.0F, -infinity}) {
        EXPECT_FALSE(search.nearest({0, 0, 0}, bad).is_found());
        EXPECT_TRUE(find_within(search, {0, 0, 0}, bad).empty());
    }
    EXPECT_TRUE(find_overlapping(search, Aabb{}).empty());
    EXPECT_TRUE(find_overlapping(search, {{nan, 0, 0}, {1, 1, 1}}).empty());
    EXPECT_TRUE(find_k(search, {0, 0, 0}, 0).empty());
}

TEST(PointSearch, DistancesAreInclusive) {
    const PointSearch search = search_of({{1, 0, 0}, {0, 2, 0}, {1, 0, 0}});
    EXPECT_EQ(search.nearest({1, 0, 3}, 3.0F).prim, 0U) << "the lower id of two";
    EXPECT_FALSE(search.nearest({1, 0, 3}, std::nextafter(3.0F, 0.0F)).is_found());
    EXPECT_EQ(find_within(search, {1, 0, 0}, 0.0F).size(), 2U);
    EXPECT_EQ(find_within(search, {0, 0, 0}, 2.0F).size(), 3U);
    EXPECT_EQ(find_overlapping(search, {{0, 0, 0}, {1, 2, 0}}).size(), 3U);
}

TEST(PointSearch, StopsWhenTold) {
    const PointSearch search = search_of(make_sphere(10, 11).vertices);
    int count = 0;
    search.for_each_within({0, 0, 0}, 5.0F, [&](const Neighbor&) { return ++count < 3; });
    EXPECT_EQ(count, 3);
    search.for_each_overlapping({{-1, -1, -1}, {1, 1, 1}},
                                [&](std::uint32_t) { return ++count < 8; });
    EXPECT_EQ(count, 8);
}

TEST(PointSearch, BatchesEqualSingleQueries) {
    const TriangleMesh mesh = make_soup(300, 0.2F, 3);
    const PointSearch search = search_of(mesh.vertices);
    const std::vector<Vec3f> places = make_query_points(mesh.view(), 120, 4);
    constexpr std::size_t k = 4;
    const std::size_t count = places.size();
    for (const int threads : {0, 1, 2}) {
        std::vector<Neighbor> nearest(count);
        std::vector<Neighbor> rows(k * count);
        std::vector<std::uint32_t> ids(k * count);
        std::vector<std::size_t> counts(count);
        search.nearest(places, nearest, PointSearch::anywhere, threads);
        search.nearest_k(places, rows, 0.4F, threads);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_TRUE(are_same({nearest[i]}, {search.nearest(places[i])}));
            auto expected = find_k(search, places[i], k, 0.4F);
            expected.resize(k);
            EXPECT_TRUE(are_same(std::vector(&rows[k * i], &rows[k * i] + k), expected));
        }
        search.within(places, 0.1F, rows, counts, threads);
        std::vector<Aabb> boxes;
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_EQ(counts[i], find_within(search, places[i], 0.1F).size());
            EXPECT_TRUE(counts[i] == 0 || rows[k * i].distance() <= 0.1F);
            boxes.push_back({places[i], places[i] + Vec3f{0.3F, 0.3F, 0.3F}});
        }
        search.overlapping(boxes, ids, counts, threads);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_EQ(counts[i], find_overlapping(search, boxes[i]).size());
        }
    }
}

TEST(PointSearch, ChecksWhatItIsGiven) {
    const std::vector<Vec3f> points{{1, 0, 0}, {0, 2, 0}, {1, 0, 0}};
    const KdTree tree = build_kd_tree(PointCloudView(points)).tree;
    EXPECT_THROW(PointSearch(tree, PointCloudView(std::span(points).first(2))), Error);
    const PointSearch search(tree, PointCloudView(points));
    std::array<Neighbor, 4> found;
    std::array<std::size_t, 2> counts{};
    EXPECT_THROW(search.nearest(points, found), Error);
    EXPECT_THROW(search.nearest_k(points, found), Error);
    EXPECT_THROW(search.within(points, 1.0F, {}, counts), Error);
    EXPECT_EQ(PointSearch(KdTree(), PointCloudView()).nearest({0, 0, 0}).is_found(), false);
}

}  // namespace
}  // namespace coppice::test
