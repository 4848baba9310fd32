#include "scenes/procedural.h"

#include "coppice/base/error.h"

#include "scenes/mesh_summary.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>

namespace coppice::lab {

namespace {

std::string name_of_case(const testing::TestParamInfo<std::string_view>& info) {
    return std::string(info.param);
}

std::vector<std::string_view> all_names() {
    std::vector<std::string_view> names;
    for (const ProceduralScene& scene : procedural_registry()) {
        names.push_back(scene.name);
    }
    return names;
}

class Procedural : public testing::TestWithParam<std::string_view> {};

INSTANTIATE_TEST_SUITE_P(All, Procedural, testing::ValuesIn(all_names()), name_of_case);

TEST_P(Procedural, IndicesAreInRangeAndCoordinatesFinite) {
    for (const std::uint32_t count : {1U, 2U, 13U, 100U, 5000U}) {
        const TriangleMesh mesh = make_procedural(GetParam(), count, 3);
        ASSERT_FALSE(mesh.triangles.empty()) << count;
        for (const TriangleIndices& corners : mesh.triangles) {
            for (const std::uint32_t corner : corners) {
                ASSERT_LT(corner, mesh.vertices.size()) << count;
            }
        }
        for (const Vec3f vertex : mesh.vertices) {
            ASSERT_TRUE(std::isfinite(vertex.x) && std::isfinite(vertex.y) &&
                        std::isfinite(vertex.z));
            ASSERT_LE(std::abs(vertex.x) + std::abs(vertex.y) + std::abs(vertex.z), 1000.0F);
        }
    }
}

TEST_P(Procedural, HasAboutAsManyTrianglesAsAskedFor) {
    for (const std::uint32_t count : {1000U, 1234U, 4567U, 20'000U, 99'999U}) {
        const auto made =
            static_cast<double>(make_procedural(GetParam(), count, 1).triangles.size());
        EXPECT_NEAR(made, count, 0.05 * count);
    }
}

TEST_P(Procedural, DependsOnItsArgumentsAlone) {
    const TriangleMesh first = make_procedural(GetParam(), 2000, 5);
    const TriangleMesh again = make_procedural(GetParam(), 2000, 5);
    const TriangleMesh other = make_procedural(GetParam(), 2000, 6);
    EXPECT_EQ(first.vertices, again.vertices);
    EXPECT_EQ(first.triangles, again.triangles);
    EXPECT_NE(first.vertices, other.vertices);
}

TEST_P(Procedural, HasNoTrianglesWithoutArea) {
    const TriangleMesh mesh = make_procedural(GetParam(), 5000, 1);
    EXPECT_EQ(summarize(mesh.view()).areas.zero_count, 0U);
}

TEST(Procedural, SpheresAndHousesAreClosed) {
    for (const std::string_view name : {"spheres", "city"}) {
        const EdgeCounts edges = summarize(make_procedural(name, 5000, 1).view()).edges;
        EXPECT_EQ(edges.boundary, 4U) << name;  // of the ground
        EXPECT_EQ(edges.non_manifold, 0U) << name;
    }
}

TEST(Procedural, NormalsOfClosedSurfacesPointOutwards) {
    for (const std::string_view name : {"spheres", "city"}) {
        const TriangleMesh mesh = make_procedural(name, 3000, 1);
        double volume = 0.0;  // by the divergence theorem; the ground at z = 0 adds nothing
        for (std::uint32_t id = 0; id < mesh.view().size(); ++id) {
            const auto [a, b, c] = mesh.view().triangle(id);
            volume += dot(to_double(a), cross(to_double(b), to_double(c))) / 6.0;
        }
        EXPECT_GT(volume, 0.0) << name;
    }
}

TEST(Procedural, SpheresAreVeryUneven) {
    const AreaDistribution areas = summarize(make_procedural("spheres", 20'000, 1).view()).areas;
    EXPECT_GT(areas.max, 1e6 * areas.percentiles[0]);
}

TEST(Procedural, CityIsAxisAligned) {
    const TriangleMesh mesh = make_procedural("city", 2000, 1);
    for (std::uint32_t id = 0; id < mesh.view().size(); ++id) {
        const Aabb box = mesh.view().bounds(id);
        EXPECT_EQ(box.extent(Axis::x) * box.extent(Axis::y) * box.extent(Axis::z), 0.0);
    }
}

TEST(Procedural, RefusesUnknownNamesAndCounts) {
    EXPECT_THROW(static_cast<void>(make_procedural("teapot", 100, 1)), Error);
    EXPECT_THROW(static_cast<void>(make_procedural("soup", 0, 1)), Error);
    EXPECT_THROW(static_cast<void>(make_procedural("soup", max_procedural_triangles + 1, 1)),
                 Error);
}

}  // namespace

}  // namespace coppice::lab
