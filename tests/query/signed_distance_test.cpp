#include "coppice/query/signed_distance.h"

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/io/load_mesh.h"

#include "query/query_points.h"
#include "support/meshes.h"
#include "support/numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace coppice::test {
namespace {

SignedDistance make_signed(const TriangleMesh& mesh) {
    return {mesh.view(), MeshSearch(build_bvh8(mesh.view()).tree)};
}

// How often a closed mesh winds around a point: 1 inside, 0 outside. Sums the solid angles of all
// triangles (van Oosterom & Strackee 1983): an oracle that knows nothing of neighbors.
double winding_number(TriangleMeshView mesh, Vec3f point) {
    double sum = 0.0;
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        const Triangle t = mesh.triangle(id);
        const Vec3d a = to_double(t[0]) - to_double(point);
        const Vec3d b = to_double(t[1]) - to_double(point);
        const Vec3d c = to_double(t[2]) - to_double(point);
        const auto length = [](Vec3d v) { return std::sqrt(dot(v, v)); };
        sum += 2.0 * std::atan2(dot(a, cross(b, c)),
                                length(a) * length(b) * length(c) + dot(a, b) * length(c) +
                                    dot(b, c) * length(a) + dot(c, a) * length(b));
    }
    return sum / (4.0 * std::numbers::pi);
}

TriangleMesh load_bunny() {
    return load_mesh(std::filesystem::path(COPPICE_TEST_DATA_DIR) / "bunny.obj");
}

// Corners so sharp that only angle-weighted normals tell their insides.
TriangleMesh make_star() {
    TriangleMesh mesh = make_sphere(8, 9);
    Random random(4);
    for (Vec3f& vertex : mesh.vertices) {
        vertex = random.uniform(0.15F, 1.0F) * vertex;
    }
    return mesh;
}

TriangleMesh inside_out(TriangleMesh mesh) {
    for (TriangleIndices& triangle : mesh.triangles) {
        std::swap(triangle[0], triangle[1]);
    }
    return mesh;
}

void check_signs(const TriangleMesh& mesh, int rounds) {
    const SignedDistance surface = make_signed(mesh);
    const double orientation = winding_number(mesh.view(), {0.01F, 0.02F, 0.01F}) > 0 ? 1.0 : -1.0;
    for (const Vec3f& point : make_query_points(mesh.view(), rounds, 5)) {
        const SignedNeighbor found = surface.nearest(point);
        EXPECT_EQ(std::abs(found.signed_distance), found.nearest.distance());
        if (found.nearest.distance() < 1e-6) continue;
        const bool is_inside = orientation * winding_number(mesh.view(), point) > 0.5;
        ASSERT_EQ(found.signed_distance < 0.0, is_inside)
            << point.x << " " << point.y << " " << point.z << " feature "
            << static_cast<int>(found.nearest.feature);
    }
}

TEST(SignedDistance, HasTheSignOfTheWindingNumber_Seed5) {
    check_signs(make_star(), 400);
    check_signs(inside_out(make_star()), 100);
    check_signs(load_bunny(), 50);
}

TEST(SignedDistance, OfAHollowSphere) {
    const TriangleMesh outer = make_sphere(20, 30);
    const TriangleMesh mesh = joined(outer, inside_out(scaled(outer, 0.5F)));
    const SignedDistance surface = make_signed(mesh);
    EXPECT_GT(surface.nearest({0, 0, 0}).signed_distance, 0.45);
    EXPECT_LT(surface.nearest({0, 0.75F, 0}).signed_distance, -0.2);
    EXPECT_GT(surface.nearest({0, 2, 0}).signed_distance, 0.9);
    EXPECT_EQ(surface.nearest(mesh.vertices[7]).signed_distance, 0.0);
}

// Each triangle with corners of its own, and one more that has collapsed onto an edge.
TEST(SignedDistance, WeldsByPosition) {
    const TriangleMesh sphere = make_sphere(10, 11);
    TriangleMesh mesh;
    for (std::uint32_t id = 0; id < sphere.view().size(); ++id) {
        add_triangle(mesh, sphere.view().triangle(id));
    }
    const Triangle first = mesh.view().triangle(0);
    mesh.triangles.insert(mesh.triangles.begin(), TriangleIndices{0, 1, 1});
    mesh.triangles.push_back({2, 2, 2});
    const SignedDistance surface = make_signed(mesh);
    const Vec3d middle = 0.5 * (to_double(first[0]) + to_double(first[1]));
    const SignedNeighbor over = surface.nearest(to_float(1.5 * middle));
    EXPECT_EQ(over.nearest.prim, 0U);
    EXPECT_GT(over.signed_distance, 0.0);
    EXPECT_LT(surface.nearest(to_float(0.999 * middle)).signed_distance, 0.0);
}

// They cannot be sorted: corners beside them in the order were not welded.
TEST(SignedDistance, DoesNotMindUnusedVerticesThatAreNaN) {
    const TriangleMesh sphere = make_sphere(30, 31);
    TriangleMesh mesh;
    for (std::uint32_t id = 0; id < sphere.view().size(); ++id) {
        add_triangle(mesh, sphere.view().triangle(id));
        if (id % 50 == 7) mesh.vertices.push_back({nan, 0, nan});
    }
    EXPECT_LT(make_signed(mesh).nearest({0, 0.9F, 0}).signed_distance, 0.0);
}

TEST(SignedDistance, OfManyPoints) {
    const TriangleMesh mesh = make_star();
    const SignedDistance surface = make_signed(mesh);
    const std::vector<Vec3f> points = make_query_points(mesh.view(), 60, 6);
    std::vector<double> found(points.size());
    surface.distances(points, found, 2);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(found[i], surface.nearest(points[i]).signed_distance);
    }
    EXPECT_THROW(surface.distances(points, std::span(found).first(3)), Error);
    EXPECT_TRUE(std::isnan(surface.nearest({NAN, 0, 0}).signed_distance));
}

void expect_refused(const TriangleMesh& mesh, const std::string& message) {
    try {
        make_signed(mesh);
        FAIL() << "not refused: " << message;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::unsupported);
        EXPECT_THAT(error.what(), testing::HasSubstr(message));
    }
}

TEST(SignedDistance, RefusesMeshesThatAreNotClosed) {
    expect_refused({}, "it has no triangles");
    expect_refused(make_triangle({Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{0, 1, 0}}),
                   "at the edge from (0, 0, 0) to (0, 1, 0) there is only triangle 0");
    TriangleMesh mesh = make_sphere(10, 11);
    std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
    expect_refused(mesh, "are oriented against each other");
    mesh = make_sphere(10, 11);
    mesh.triangles.push_back(mesh.triangles[3]);
    expect_refused(mesh, "there are 3 triangles");
}

}  // namespace
}  // namespace coppice::test
