#include "io/test_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::string_view three_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// An OBJ file of three vertices (lines 1 to 3) and `rest`.
Loaded load_with(const std::string& rest) {
    return load("a.obj", std::string(three_vertices) + rest);
}

std::string error_with(const std::string& rest) {
    return error_of("a.obj", std::string(three_vertices) + rest);
}

TEST(LoadObj, ReadsVerticesAndFacesInOrder) {
    const auto [mesh, report] = load("a.obj", "v 1 2 3\nv -4 5.5 6e-2\nv 7 8 9\nf 3 1 2\n");
    EXPECT_THAT(mesh.vertices, ElementsAre(Vec3f{1, 2, 3}, Vec3f{-4, 5.5F, 0.06F}, Vec3f{7, 8, 9}));
    EXPECT_THAT(mesh.triangles, ElementsAre(TriangleIndices{2, 0, 1}));
    EXPECT_EQ(report.format, "obj");
    EXPECT_EQ(report.vertex_count, 3U);
    EXPECT_EQ(report.face_count, 1U);
    EXPECT_EQ(report.triangle_count, 1U);
    EXPECT_EQ(report.file_bytes, 38U);
    EXPECT_GT(report.load_seconds, 0.0);
}

TEST(LoadObj, TakesEveryFormOfACorner) {
    const auto [mesh, report] =
        load_with("vt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3/1\nf -3/-1/-1 -2//-1 -1/-1\n");
    EXPECT_THAT(mesh.triangles, ElementsAre(TriangleIndices{0, 1, 2}, TriangleIndices{0, 1, 2}));
    EXPECT_EQ(report.negative_index_count, 3U);
    EXPECT_EQ(report.ignored_line_count, 2U);
}

TEST(LoadObj, ResolvesNegativeIndicesWhereTheFaceStands) {
    const auto [mesh, report] = load_with("f -1 -2 -3\nv 9 9 9\nf -1 -2 -3\n");
    EXPECT_THAT(mesh.triangles, ElementsAre(TriangleIndices{2, 1, 0}, TriangleIndices{3, 2, 1}));
}

TEST(LoadObj, TakesAFaceBeforeItsVertices) {
    const auto [mesh, report] = load("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_THAT(mesh.triangles, ElementsAre(TriangleIndices{0, 1, 2}, TriangleIndices{0, 1, 2}));
}

TEST(LoadObj, TakesAnyLineEnd) {
    const std::string unix_text = std::string(three_vertices) + "\n# note\nf 1 2 3\n";
    const Loaded expected = load("a.obj", unix_text);
    std::string mac_text = unix_text;
    std::replace(mac_text.begin(), mac_text.end(), '\n', '\r');
    for (const std::string& text :
         {with_crlf(unix_text), mac_text, unix_text.substr(0, unix_text.size() - 1)}) {
        EXPECT_EQ(bits_of(load("a.obj", text).mesh), bits_of(expected.mesh));
    }
}

TEST(LoadObj, TakesTabsBlanksCommentsAndTheByteOrderMark) {
    const auto [mesh, report] = load("A.OBJ",
                                     "\xEF\xBB\xBFv 0 0 0\n\t v\t1  0\t0 \t\nv 0 1 0# here\n"
                                     "\n \t\n# f 1 2 9\n  f 1 2\t3 # and \\\ng it's # \\\n");
    EXPECT_THAT(mesh.vertices, ElementsAre(Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{0, 1, 0}));
    EXPECT_THAT(mesh.triangles, ElementsAre(TriangleIndices{0, 1, 2}));
    EXPECT_EQ(report.ignored_line_count, 1U);
}

TEST(LoadObj, JoinsContinuedLines) {
    for (const bool is_crlf : {false, true}) {
        const std::string text = "v 0 \\\n 0 0\nv 1 0 0\nv 0 1 \\\n\\\n0\nf 1 2\\\n3\n";
        const auto [mesh, report] = load("a.obj", is_crlf ? with_crlf(text) : text);
        EXPECT_THAT(mesh.vertices, ElementsAre(Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{0, 1, 0}));
        EXPECT_THAT(mesh.triangles, ElementsAre(TriangleIndices{0, 1, 2}));
    }
}

TEST(LoadObj, IgnoresWeightsAndColours) {
    const auto [mesh, report] = load("a.obj",
                                     "v 1 2 3 0.5\nv 4 5 6 0.1 0.2 0.3\n"
                                     "v 7 8 9 1 0.1 0.2 0.3\nf 1 2 3\n");
    EXPECT_THAT(mesh.vertices, ElementsAre(Vec3f{1, 2, 3}, Vec3f{4, 5, 6}, Vec3f{7, 8, 9}));
}

TEST(LoadObj, CutsPolygonsIntoFans) {
    const auto [mesh, report] = load_with("v 1 1 0\nv 2 2 0\nf 1 2 3\nf 5 4 3 2 1\n");
    EXPECT_THAT(mesh.triangles, ElementsAre(TriangleIndices{0, 1, 2}, TriangleIndices{4, 3, 2},
                                            TriangleIndices{4, 2, 1}, TriangleIndices{4, 1, 0}));
    EXPECT_EQ(report.face_count, 2U);
    EXPECT_EQ(report.triangle_count, 4U);
    EXPECT_EQ(report.polygons.count, 1U);
    EXPECT_THAT(report.polygons.first, ElementsAre(1));
}

TEST(LoadObj, TakesAPolygonOfManyCorners) {
    constexpr std::uint32_t corner_count = 300'000;  // a line of two megabytes
    std::string text;
    std::string face = "f";
    for (std::uint32_t i = 1; i <= corner_count; ++i) {
        text += "v " + std::to_string(i) + " 0 0\n";
        face += " " + std::to_string(i);
    }
    const auto [mesh, report] = load("a.obj", text + face);
    ASSERT_EQ(mesh.triangles.size(), corner_count - 2);
    EXPECT_EQ(mesh.triangles.back(), (TriangleIndices{0, corner_count - 2, corner_count - 1}));
}

TEST(LoadObj, ReadsGzippedFiles) {
    const std::string text = std::string(three_vertices) + "f 1 2 3\n";
    EXPECT_EQ(bits_of(load("a.obj.gz", gzipped(text)).mesh), bits_of(load("a.obj", text).mesh));
    EXPECT_EQ(error_of("a.obj.gz", gzipped(text + "f 1 2 4\n")),
              "a.obj.gz:5: face index 4 out of range (3 vertices)");
}

TEST(LoadObj, NamesTheLineOfABadIndex) {
    EXPECT_EQ(error_with("f 1 2 3\nf 1 2 4\n"), "a.obj:5: face index 4 out of range (3 vertices)");
    EXPECT_EQ(error_with("f 9 8 7\nf 1 2 99\nv 1 1 1\n"),
              "a.obj:4: face index 9 out of range (4 vertices)");
    EXPECT_EQ(error_with("f 1 2 4\nf 1 2 5\nv 1 1 1\n"),
              "a.obj:5: face index 5 out of range (4 vertices)");
    EXPECT_EQ(error_with("f 1 2 0\n"), "a.obj:4: face index 0 (OBJ indices start at 1)");
    EXPECT_EQ(error_with("f 1 2 -4\nv 1 1 1\n"),
              "a.obj:4: face index -4 out of range (3 vertices so far)");
    EXPECT_EQ(error_with("f 1 2 99999999999\n"),
              "a.obj:4: face index 99999999999 out of range (3 vertices)");
    EXPECT_EQ(error_with("f 1 2 4294967297\n"),  // 1 in 32 bits
              "a.obj:4: face index 4294967297 out of range (3 vertices)");
}

TEST(LoadObj, NamesTheLineOfAMalformedCorner) {
    for (const char* const corner :
         {"x", "1.5", "1e0", "3x", "1/", "1//", "/1", "1/x", "1//x", "1/1/", "1/1/1/1", "1\\",
          "--1", "nan", "0x1", "99999999999999999999", "1/99999999999999999999"}) {
        EXPECT_EQ(error_with(std::string("\nf 1 ") + corner + " 2\n"),
                  std::string("a.obj:5: malformed face index '") + corner + "'");
    }
    EXPECT_EQ(error_with("f\n"), "a.obj:4: face without indices");
    EXPECT_EQ(error_with(std::string("f 1 2 3\0x\n", 10)), "a.obj:4: malformed face index '3?x'");
}

TEST(LoadObj, NamesTheLineOfABadCoordinate) {
    const auto error_at = [](const std::string& x) {
        return error_of("a.obj", "v 0 0 0\n# note\nv 0 " + x + " 0\n");
    };
    for (const char* const x : {"nan", "-nan", "inf", "-INF", "infinity"}) {
        EXPECT_EQ(error_at(x), std::string("a.obj:3: coordinate '") + x + "' is not finite");
    }
    for (const char* const x : {"1e39", "-1e400", "3.5e38", "1e5000"}) {
        EXPECT_EQ(error_at(x),
                  std::string("a.obj:3: coordinate '") + x + "' is beyond the range of float");
    }
    for (const char* const x : {"abc", "1x", "1,5", "--1", "+-1", "1e", "0x10", "1.2.3", "."}) {
        EXPECT_EQ(error_at(x), std::string("a.obj:3: malformed coordinate '") + x + "'");
    }
}

TEST(LoadObj, NamesTheLineOfAVertexWithTooFewOrTooManyNumbers) {
    EXPECT_EQ(error_with("v 1 2\n"), "a.obj:4: vertex of 2 numbers (3, 4, 6 or 7 expected)");
    EXPECT_EQ(error_with("v\n"), "a.obj:4: vertex of 0 numbers (3, 4, 6 or 7 expected)");
    EXPECT_EQ(error_with("v 1 2 3 4 5\n"), "a.obj:4: vertex of 5 numbers (3, 4, 6 or 7 expected)");
    EXPECT_EQ(error_with("v 1 2 3 x\n"), "a.obj:4: malformed number 'x' after a vertex");
}

TEST(LoadObj, CountsLinesThroughCrlfCommentsAndContinuations) {
    const std::string text = "# one\n\nv 0 0 \\\n0\nv 1 0 0\nv 0 1 0\nf 1 \\\n2 \\\n3\nf 1 2 x\n";
    EXPECT_EQ(error_of("a.obj", text), "a.obj:10: malformed face index 'x'");
    EXPECT_EQ(error_of("a.obj", with_crlf(text)), "a.obj:10: malformed face index 'x'");
    // A statement over several lines is named by its first.
    EXPECT_EQ(error_with("f 1 \\\n2 \\\nx\n"), "a.obj:4: malformed face index 'x'");
}

TEST(LoadObj, RefusesAFileWithoutFaces) {
    EXPECT_EQ(error_of("a.obj", three_vertices), "a.obj: no faces");
    EXPECT_EQ(error_of("a.obj", "# nothing\n"), "a.obj: no faces");
    EXPECT_EQ(error_of("a.obj", "hello world\n"), "a.obj: no faces");
    EXPECT_EQ(error_with("f 1 2\nl 1 2\n"), "a.obj: no faces of three or more corners");
}

TEST(LoadObj, CutsLongWordsInMessages) {
    EXPECT_THAT(error_with("f 1 2 " + std::string(1000, 'x') + "\n"),
                HasSubstr("'" + std::string(40, 'x') + "...'"));
}

}  // namespace
}  // namespace coppice::test
