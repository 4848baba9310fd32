#include "scenes/mesh_summary.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace coppice::lab {

namespace {

/// Two triangles of a unit square, one far corner used by a third, larger and by one without area.
TriangleMesh example() {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 40}, {0, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 4}, {0, 5, 0}};
    return mesh;
}

TEST(MeshSummary, Counts) {
    const MeshSummary summary = summarize(example().view());
    EXPECT_EQ(summary.vertex_count, 6U);
    EXPECT_EQ(summary.distinct_vertex_count, 5U);
    EXPECT_EQ(summary.triangle_count, 4U);
    EXPECT_EQ(summary.bounds, (Aabb{{0, 0, 0}, {1, 1, 40}}));
}

TEST(MeshSummary, Areas) {
    const AreaDistribution areas = summarize(example().view()).areas;
    EXPECT_EQ(areas.min, 0.0);
    EXPECT_EQ(areas.max, 20.0);
    EXPECT_EQ(areas.total, 21.0);
    EXPECT_EQ(areas.mean, 5.25);
    EXPECT_EQ(areas.zero_count, 1U);
    EXPECT_THAT(areas.percentiles, testing::ElementsAre(0.0, 0.0, 0.5, 20.0, 20.0));
    ASSERT_EQ(areas.decades.size(), 3U);  // 0.1 to 1, 1 to 10 (none), 10 to 100
    EXPECT_EQ(areas.decades[0].exponent, -1);
    EXPECT_EQ(areas.decades[0].count, 2U);
    EXPECT_EQ(areas.decades[1].count, 0U);
    EXPECT_EQ(areas.decades[2].exponent, 1);
    EXPECT_EQ(areas.decades[2].count, 1U);
}

TEST(MeshSummary, Edges) {
    const EdgeCounts edges = summarize(example().view()).edges;
    EXPECT_EQ(edges.edges, 8U);         // five of the square, two of the large triangle, 0-5
    EXPECT_EQ(edges.boundary, 5U);      // 1-2, 2-3, 3-0, 1-4, 4-0
    EXPECT_EQ(edges.non_manifold, 0U);  // 0-1, 0-2 and 0-5 twice
}

TEST(MeshSummary, OfNoTriangles) {
    TriangleMesh points;
    points.vertices = {{1, 2, 3}, {1, 2, 3}};
    const MeshSummary summary = summarize(points.view());
    EXPECT_EQ(summary.distinct_vertex_count, 1U);
    EXPECT_EQ(summary.areas.max, 0.0);
    EXPECT_TRUE(summary.areas.decades.empty());
    EXPECT_EQ(summary.edges.edges, 0U);
    EXPECT_TRUE(nlohmann::json(summarize({}))["bounds"].is_null());
}

TEST(MeshSummary, Json) {
    const nlohmann::json json = summarize(example().view());
    EXPECT_EQ(json["triangle_count"], 4);
    EXPECT_EQ(json["bounds"]["upper"], (nlohmann::json{1.0, 1.0, 40.0}));
    EXPECT_EQ(json["areas"]["percentiles"]["50"], 0.5);
    EXPECT_EQ(json["areas"]["decades"][0]["exponent"], -1);
    EXPECT_EQ(json["edges"]["boundary_count"], 5);
}

}  // namespace

}  // namespace coppice::lab
