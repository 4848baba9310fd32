#include "coppice/query/mesh_search.h"

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/cost/measure.h"
#include "coppice/query/brute_force_search.h"

#include "query/query_points.h"
#include "support/meshes.h"
#include "support/numbers.h"
#include "support/scene_matrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace coppice::test {
namespace {

// Cells by planes, so small that many triangles are in several.
Bvh8 build_cut(TriangleMeshView mesh) {
    return build_bvh8(mesh, {.sample = {.rate = 0.5},
                             .preset = Bvh8Preset::balanced,
                             .cell_size = 64,
                             .sampled_from = 0})
        .tree;
}

bool is_same(const SurfaceNeighbor& a, const SurfaceNeighbor& b) {
    return a.distance_squared == b.distance_squared && a.prim == b.prim && a.point == b.point &&
           a.u == b.u && a.v == b.v && a.feature == b.feature;
}

template <typename Found>
testing::AssertionResult are_same(const std::vector<Found>& found,
                                  const std::vector<Found>& expected) {
    for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i) {
        if (is_same(found[i], expected[i])) continue;
        return testing::AssertionFailure()
               << "at " << i << ": " << found[i].prim << " at " << found[i].distance()
               << " instead of " << expected[i].prim << " at " << expected[i].distance();
    }
    if (found.size() == expected.size()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << found.size() << " instead of " << expected.size();
}

std::vector<SurfaceNeighbor> find_within(const MeshSearch& search, Vec3f at, float radius) {
    std::vector<SurfaceNeighbor> found;
    search.for_each_within(at, radius, [&](const SurfaceNeighbor& f) { found.push_back(f); });
    std::sort(found.begin(), found.end(), [](const SurfaceNeighbor& a, const SurfaceNeighbor& b) {
        return std::tie(a.distance_squared, a.prim) < std::tie(b.distance_squared, b.prim);
    });
    return found;
}

std::vector<SurfaceNeighbor> find_k(const MeshSearch& search, Vec3f at, std::size_t k,
                                    float max_distance = infinity) {
    std::vector<SurfaceNeighbor> found(k);
    found.resize(search.nearest_k(at, found, max_distance));
    return found;
}

std::vector<std::uint32_t> find_overlapping(const MeshSearch& search, const Aabb& box) {
    std::vector<std::uint32_t> found;
    search.for_each_overlapping(box, [&](std::uint32_t id) { found.push_back(id); });
    std::sort(found.begin(), found.end());
    return found;
}

class MeshSearchScene : public testing::TestWithParam<NamedScene> {};

void check_near(const MeshSearch& search, Vec3f at, const std::vector<SurfaceNeighbor>& all) {
    const auto first = [&](std::size_t count) {
        return std::vector(all.begin(),
                           all.begin() + static_cast<std::ptrdiff_t>(std::min(count, all.size())));
    };
    const SurfaceNeighbor one = search.nearest(at);
    ASSERT_TRUE(are_same(one.is_found() ? std::vector{one} : first(0), first(1)));
    ASSERT_TRUE(are_same(find_k(search, at, 7), first(7)));
    if (all.empty()) return;
    const auto radius = static_cast<float>(all[all.size() / 7].distance());
    const auto beyond = std::find_if(all.begin(), all.end(), [&](const SurfaceNeighbor& f) {
        return f.distance_squared > static_cast<double>(radius) * static_cast<double>(radius);
    });
    const std::vector within(all.begin(), beyond);
    ASSERT_TRUE(are_same(find_within(search, at, radius), within));
    ASSERT_TRUE(are_same(find_k(search, at, 3 * all.size(), radius), within));
}

TEST_P(MeshSearchScene, EqualsBruteForce) {
    const TriangleMesh mesh = GetParam().make();
    const std::vector<Vec3f> points = make_query_points(mesh.view(), 3, 41);
    for (const Bvh8& tree : {build_bvh8(mesh.view()).tree, build_cut(mesh.view())}) {
        for (const Isa isa : available_isas()) {
            const MeshSearch search(tree, isa);
            for (std::size_t i = 0; i < points.size(); ++i) {
                SCOPED_TRACE(i);
                check_near(search, points[i], brute_force_within(mesh.view(), points[i]));
                Aabb box;
                box.grow(points[i]);
                EXPECT_EQ(find_overlapping(search, box), brute_force_overlapping(mesh.view(), box));
                box.grow(points[i * i % points.size()]);
                EXPECT_EQ(find_overlapping(search, box), brute_force_overlapping(mesh.view(), box));
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seed41, MeshSearchScene, testing::ValuesIn(scene_matrix()), scene_name);

TEST(MeshSearch, FindsNothingNearNowhere) {
    const MeshSearch search(build_bvh8(make_sphere(10, 11).view()).tree);
    for (const Vec3f& bad : {Vec3f{nan, 0, 0}, Vec3f{0, nan, 0}, Vec3f{0, 0, infinity}}) {
        EXPECT_FALSE(search.nearest(bad).is_found());
        EXPECT_TRUE(find_k(search, bad, 3).empty());
        EXPECT_TRUE(find_within(search, bad, infinity).empty());
        EXPECT_TRUE(find_overlapping(search, {bad, bad}).empty() || bad.z == infinity);
    }
    for (const float bad : {nan, -1.0F, -infinity}) {
        EXPECT_FALSE(search.nearest({0, 0, 0}, bad).is_found());
        EXPECT_TRUE(find_within(search, {0, 0, 0}, bad).empty());
    }
    EXPECT_TRUE(find_overlapping(search, Aabb{}).empty());
    EXPECT_TRUE(find_k(search, {0, 0, 0}, 0).empty());
}

TEST(MeshSearch, DistancesAreInclusive) {
    const MeshSearch search(build_bvh8(make_sheet(4, {0, 0, 2}, {1, 0, 0}, {0, 1, 0}).view()).tree);
    EXPECT_TRUE(search.nearest({1.5F, 1.25F, 0}, 2.0F).is_found());
    EXPECT_FALSE(search.nearest({1.5F, 1.25F, 0}, std::nextafter(2.0F, 0.0F)).is_found());
    EXPECT_EQ(find_within(search, {1.5F, 1.25F, 0}, 2.0F).size(), 1U);
    EXPECT_EQ(find_within(search, {0.0F, 0.0F, 2}, 0.0F).size(), 2U) << "a corner of two";
    EXPECT_EQ(find_overlapping(search, {{-9, -9, 2}, {0, 0, 3}}).size(), 2U);
    EXPECT_EQ(find_overlapping(search, {{-9, -9, 2.0001F}, {9, 9, 3}}).size(), 0U);
    const Aabb everywhere{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
    EXPECT_EQ(find_overlapping(search, everywhere).size(), 32U);
}

int& visit_count() {
    static int count = 0;
    return count;
}

bool visit_two(const SurfaceNeighbor& /*found*/) {
    return ++visit_count() < 2;
}

TEST(MeshSearch, ShowsWhatItFindsToFunctions) {
    const MeshSearch search(build_bvh8(make_sphere(10, 11).view()).tree);
    search.for_each_within({0, 0, 0}, 5.0F, visit_two);
    EXPECT_EQ(visit_count(), 2);
    search.for_each_within({0, 0, 0}, 5.0F, &visit_two);
    EXPECT_EQ(visit_count(), 3);
}

TEST(MeshSearch, StopsWhenTold) {
    const MeshSearch search(build_bvh8(make_sphere(10, 11).view()).tree);
    int count = 0;
    search.for_each_within({0, 0, 0}, 5.0F, [&](const SurfaceNeighbor&) { return ++count < 3; });
    EXPECT_EQ(count, 3);
    search.for_each_overlapping({{-1, -1, -1}, {1, 1, 1}},
                                [&](std::uint32_t) { return ++count < 8; });
    EXPECT_EQ(count, 8);
}

TEST(MeshSearch, BatchesEqualSingleQueries) {
    const TriangleMesh mesh = make_soup(500, 0.2F, 3);
    const MeshSearch search(build_cut(mesh.view()));
    EXPECT_GT(measure(search.tree(), {}).reference_count, mesh.triangles.size()) << "some twice";
    const std::vector<Vec3f> points = make_query_points(mesh.view(), 120, 4);
    std::vector<Aabb> boxes;
    boxes.reserve(points.size());
    for (const Vec3f& point : points) {
        boxes.push_back({point, point + Vec3f{0.3F, 0.3F, 0.3F}});
    }
    for (const int threads : {0, 1, 2}) {
        constexpr std::size_t k = 4;
        std::vector<SurfaceNeighbor> nearest(points.size());
        std::vector<SurfaceNeighbor> rows(k * points.size());
        std::vector<std::uint32_t> ids(k * points.size());
        std::vector<std::size_t> counts(points.size());
        search.nearest(points, nearest, MeshSearch::anywhere, threads);
        search.nearest_k(points, rows, 0.4F, threads);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_TRUE(is_same(nearest[i], search.nearest(points[i])));
            const auto row = std::vector(&rows[k * i], &rows[k * i] + k);
            auto expected = find_k(search, points[i], k, 0.4F);
            expected.resize(k);
            EXPECT_TRUE(are_same(row, expected));
        }
        search.within(points, 0.3F, rows, counts, threads);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_EQ(counts[i], find_within(search, points[i], 0.3F).size());
            EXPECT_TRUE(counts[i] == 0 || rows[k * i].distance() <= 0.3F);
        }
        search.overlapping(boxes, ids, counts, threads);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto expected = find_overlapping(search, boxes[i]);
            EXPECT_EQ(counts[i], expected.size());
            if (counts[i] > 0) {
                EXPECT_TRUE(std::binary_search(expected.begin(), expected.end(), ids[k * i]));
            }
        }
    }
}

TEST(MeshSearch, BatchesCheckTheirSpans) {
    const MeshSearch search{Bvh8()};
    const std::array<Vec3f, 3> points{};
    std::array<SurfaceNeighbor, 4> found;
    std::array<std::size_t, 2> counts{};
    EXPECT_THROW(search.nearest(points, found), Error);
    EXPECT_THROW(search.nearest_k(points, found), Error);
    EXPECT_THROW(search.within(points, 1.0F, {}, counts), Error);
    EXPECT_THROW(search.nearest(points, std::span(found).first(3), 1.0F, -1), Error);
    EXPECT_THROW(search.nearest_k(std::span<const Vec3f>{}, found), Error);
    EXPECT_NO_THROW(search.nearest(std::span<const Vec3f>{}, {}));
}

}  // namespace
}  // namespace coppice::test
