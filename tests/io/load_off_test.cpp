#include "io/test_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice::test {
namespace {

using testing::ElementsAre;

TEST(LoadOff, TakesPolygonsColoursAndComments) {
    const auto [mesh, report] = load("a.off",
                                     "OFF 4 3 0 # counts\n0 0 0\n\n1 0 0\n1 1 0 # corner\n0 1 0\n"
                                     "4 0 1 2 3 255 0 0\n2 0 1\n3 0 1 2\n");
    EXPECT_THAT(mesh.triangles, ElementsAre(TriangleIndices{0, 1, 2}, TriangleIndices{0, 2, 3},
                                            TriangleIndices{0, 1, 2}));
    EXPECT_THAT(report.polygons.first, ElementsAre(0));
    EXPECT_THAT(report.degenerate_faces.first, ElementsAre(1));
}

TEST(LoadOff, NamesTheLineOfABadRow) {
    const auto error = [](const std::string& rest) {
        return error_of("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n" + rest);
    };
    EXPECT_EQ(error("0 1 0\n3 0 1 2\n"), "");
    EXPECT_EQ(error("0 nan 0\n3 0 1 2\n"), "a.off:5: coordinate 'nan' is not finite");
    EXPECT_EQ(error("0 1\n3 0 1 2\n"), "a.off:5: vertex with fewer than three numbers");
    EXPECT_EQ(error("0 1 0\n3 0 1 3\n"), "a.off:6: vertex index 3 out of range (3 vertices)");
    EXPECT_EQ(error("0 1 0\n3 0 1 -1\n"), "a.off:6: vertex index -1 out of range (3 vertices)");
    EXPECT_EQ(error("0 1 0\n3 0 1 x\n"), "a.off:6: malformed vertex index 'x'");
    EXPECT_EQ(error("0 1 0\n3 0 1\n"), "a.off:6: face with fewer than 3 indices");
    EXPECT_EQ(error("0 1 0\nx 0 1 2\n"), "a.off:6: malformed corner count 'x'");
    EXPECT_EQ(error("0 1 0\n"),
              "a.off:5: file ends before all vertices and faces that its header declares");
    EXPECT_EQ(error_of("a.off", "OFF\n4000000000 1 0\n0 0 0\n"),
              "a.off:3: file ends before all vertices and faces that its header declares");
    EXPECT_EQ(error_of("a.off", "OFF\n-1 1 0\n"), "a.off:2: malformed count '-1'");
    EXPECT_EQ(error_of("a.off", "OFF BINARY\n"), "a.off:1: malformed count 'BINARY'");
    EXPECT_EQ(error_of("a.off", "4OFF\n"),
              "a.off:1: '4OFF' is not supported: only three-dimensional OFF files are");
    EXPECT_EQ(error_of("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), "a.off: no faces");
    EXPECT_EQ(error_of("a.off", "FOO\n"), "a.off:1: not an OFF file: it does not begin with 'OFF'");
}

TEST(LoadOff, TakesItsKindsAndLayouts) {
    const std::string rows = "0 0 0\n1 0 0\n0 1 0\n3 2 1 0\n";
    const auto expected = bits_of(load("a.off", "OFF\n3 1 3\n" + rows).mesh);
    for (const std::string& text :
         {"# first\n\nOFF\n# then\n3\n1 3\n" + rows, "OFF 3 1 3\n" + rows,
          with_crlf("OFF\n3 1 3\n" + rows),
          std::string("COFF\n3 1 3\n0 0 0 255 0 0 1\n1 0 0 0 0 0 1\n0 1 0 9 9 9 1\n3 2 1 0\n")}) {
        EXPECT_EQ(bits_of(load("a.off", text).mesh), expected) << text;
    }
    EXPECT_EQ(load("a.off", "OFF\n3 1 3\n" + rows + "\nrest").report.trailing_byte_count, 4U);
}

TEST(LoadOff, TakesAPolygonOfManyCorners) {
    std::string text = "OFF 100 1 0\n";
    std::string face = "100";
    for (int i = 0; i < 100; ++i) {
        text += std::to_string(i) + " 0 0\n";
        face += " " + std::to_string(i);
    }
    EXPECT_EQ(load("a.off", text + face).mesh.triangles.size(), 98U);
}

}  // namespace
}  // namespace coppice::test
