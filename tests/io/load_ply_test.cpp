#include "io/test_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <limits>

namespace coppice::test {
namespace {

using testing::ElementsAre;

/// A header of the given format whose declarations are `lines`.
std::string header(const std::string& format, const std::string& lines) {
    return "ply\nformat " + format + " 1.0\n" + lines + "end_header\n";
}

std::string ascii(const std::string& lines, const std::string& rows) {
    return header("ascii", lines) + rows;
}

const std::string vertex3 =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string face1 = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string rows3 = "0 0 0\n1 0 0\n0 1 0\n";

class LoadPlyBinary : public testing::TestWithParam<bool> {
protected:
    [[nodiscard]] static std::string format() {
        return GetParam() ? "binary_big_endian" : "binary_little_endian";
    }

    template <typename T>
    [[nodiscard]] static std::string bytes(T value) {
        return binary(value, GetParam());
    }

    template <typename T>
    [[nodiscard]] static std::string bytes(T a, T b, T c) {
        return bytes(a) + bytes(b) + bytes(c);
    }
};

INSTANTIATE_TEST_SUITE_P(ByteOrder, LoadPlyBinary, testing::Bool(), [](const auto& each) {
    return each.param ? "BigEndian" : "LittleEndian";
});

TEST(LoadPly, ReadsAscii) {
    const auto [mesh, report] =
        load("a.ply", ascii("comment made by hand\nobj_info none\n" + vertex3 + face1,
                            "0 0 0\n\n 1\t2.5 -3e-1 \n4 5 +6\n3 2 0 1\n"));
    EXPECT_THAT(mesh.vertices, ElementsAre(Vec3f{0, 0, 0}, Vec3f{1, 2.5F, -0.3F}, Vec3f{4, 5, 6}));
    EXPECT_THAT(mesh.triangles, ElementsAre(TriangleIndices{2, 0, 1}));
    EXPECT_EQ(report.format, "ply");
    EXPECT_EQ(report.face_count, 1U);
    EXPECT_EQ(report.trailing_byte_count, 0U);
}

TEST(LoadPly, TakesCrlfAndGzip) {
    const std::string text = ascii(vertex3 + face1, rows3 + "3 2 0 1\n");
    const auto expected = bits_of(load("a.ply", text).mesh);
    EXPECT_EQ(bits_of(load("a.PLY", with_crlf(text)).mesh), expected);
    EXPECT_EQ(bits_of(load("a.ply.gz", gzipped(text)).mesh), expected);
}

TEST_P(LoadPlyBinary, ReadsVerticesAndFaces) {
    const std::string body = bytes(1.0F, 2.5F, -3e-30F) + bytes(4.0F, 5.0F, 6.0F) +
                             bytes(7.0F, 8.0F, 1e-45F) + "\3" + bytes<std::int32_t>(2, 0, 1);
    const std::string file = header(format(), vertex3 + face1) + body;
    for (const auto& [mesh, report] : {load("a.ply", file), load("a.ply.gz", gzipped(file))}) {
        EXPECT_THAT(mesh.vertices,
                    ElementsAre(Vec3f{1, 2.5F, -3e-30F}, Vec3f{4, 5, 6}, Vec3f{7, 8, 1e-45F}));
        EXPECT_THAT(mesh.triangles, ElementsAre(TriangleIndices{2, 0, 1}));
    }
}

TEST_P(LoadPlyBinary, TakesCrlfInTheHeader) {
    const std::string body = bytes(10.0F, 13.0F, 0.0F) + bytes(4.0F, 5.0F, 6.0F) +
                             bytes(7.0F, 8.0F, 9.0F) + "\3" + bytes<std::int32_t>(2, 0, 1);
    const auto [mesh, report] = load("a.ply", with_crlf(header(format(), vertex3 + face1)) + body);
    EXPECT_THAT(mesh.vertices, ElementsAre(Vec3f{10, 13, 0}, Vec3f{4, 5, 6}, Vec3f{7, 8, 9}));
}

TEST_P(LoadPlyBinary, TakesPropertiesOfAnyTypeInAnyOrderAndUnknownElements) {
    const std::string lines =
        "element material 2\nproperty list ushort double weights\nproperty char kind\n"
        "element vertex 3\nproperty uchar red\nproperty double z\nproperty list int8 short rings\n"
        "property int16 x\nproperty float nx\nproperty uint8 y\nproperty list uint float more\n"
        "element edge 1\nproperty int vertex1\nproperty int vertex2\n"
        "element face 2\nproperty float32 quality\nproperty list uint16 uint32 vertex_index\n"
        "property list uchar float texcoord\n"
        "element empty 4000000000\n";
    std::string body;
    body += bytes<std::uint16_t>(2) + bytes(0.5) + bytes(0.25) + "\1";
    body += bytes<std::uint16_t>(0) + "\2";
    for (std::int16_t i = 0; i < 3; ++i) {
        body += "\xFF" + bytes(0.5 * i) + "\2" + bytes<std::int16_t>(-1) + bytes<std::int16_t>(-2);
        body += bytes(static_cast<std::int16_t>(-100 * i)) + bytes(9.0F) +
                bytes(static_cast<std::uint8_t>(100 * i)) + bytes<std::uint32_t>(1) + bytes(7.0F);
    }
    body += bytes<std::int32_t>(0) + bytes<std::int32_t>(1);
    for (const std::uint32_t first : {0U, 2U}) {
        body += bytes(1.5F) + bytes<std::uint16_t>(3) + bytes(first, 1U, 2U - first);
        body += "\2" + bytes(3.0F) + bytes(4.0F);
    }
    const auto [mesh, report] = load("a.ply", header(format(), lines) + body);
    EXPECT_THAT(mesh.vertices,
                ElementsAre(Vec3f{0, 0, 0}, Vec3f{-100, 100, 0.5F}, Vec3f{-200, 200, 1}));
    EXPECT_THAT(mesh.triangles, ElementsAre(TriangleIndices{0, 1, 2}, TriangleIndices{2, 1, 0}));
    EXPECT_EQ(report.ignored_element_count, 4'000'000'003U);
}

TEST_P(LoadPlyBinary, ReadsEveryScalarTypeAsACoordinate) {
    const std::vector<std::pair<std::string, std::string>> values = {
        {"char", bytes<std::int8_t>(-7)},
        {"int8", bytes<std::int8_t>(-7)},
        {"uchar", bytes<std::uint8_t>(200)},
        {"uint8", bytes<std::uint8_t>(200)},
        {"short", bytes<std::int16_t>(-300)},
        {"int16", bytes<std::int16_t>(-300)},
        {"ushort", bytes<std::uint16_t>(65'000)},
        {"uint16", bytes<std::uint16_t>(65'000)},
        {"int", bytes<std::int32_t>(-70'000)},
        {"int32", bytes<std::int32_t>(-70'000)},
        {"uint", bytes<std::uint32_t>(4'000'000'000)},
        {"uint32", bytes<std::uint32_t>(4'000'000'000)},
        {"float", bytes(0.1F)},
        {"float32", bytes(0.1F)},
        {"double", bytes(-1e-3)},
        {"float64", bytes(-1e-3)}};
    std::vector<float> read;
    for (const auto& [type, value] : values) {
        const std::string lines =
            "element vertex 1\nproperty uchar x\nproperty " + type + " y\nproperty uchar z\n";
        const auto [mesh, report] = load("a.ply", header(format(), lines) + "\1" + value + "\2");
        ASSERT_EQ(mesh.vertices.size(), 1U);
        EXPECT_EQ(mesh.vertices[0].x, 1.0F);
        EXPECT_EQ(mesh.vertices[0].z, 2.0F);
        read.push_back(mesh.vertices[0].y);
    }
    EXPECT_THAT(read, ElementsAre(-7, -7, 200, 200, -300, -300, 65'000, 65'000, -70'000, -70'000,
                                  4e9F, 4e9F, 0.1F, 0.1F, -1e-3F, -1e-3F));
}

TEST_P(LoadPlyBinary, NamesTheByteWhereATruncatedFileEnds) {
    const std::string head = header(format(), vertex3 + face1);
    const std::string body = bytes(1.0F, 2.0F, 3.0F) + bytes(4.0F, 5.0F, 6.0F) +
                             bytes(7.0F, 8.0F, 9.0F) + "\3" + bytes<std::int32_t>(2, 0, 1);
    ASSERT_EQ(error_of("a.ply", head + body), "");
    for (std::size_t size = 0; size < body.size(); ++size) {
        const std::string rows = size < 36
                                     ? std::to_string(size / 12) + " of 3 rows of element 'vertex'"
                                     : "0 of 1 rows of element 'face'";
        EXPECT_EQ(
            error_of("a.ply", head + body.substr(0, size)),
            "a.ply: file ends at byte " + std::to_string(head.size() + size) + ", after " + rows);
    }
}

TEST_P(LoadPlyBinary, NamesTheVertexOfABadCoordinateAndTheFaceOfABadIndex) {
    const std::string head = header(format(), vertex3 + face1);
    const std::string good = bytes(1.0F, 2.0F, 3.0F);
    const std::string face = "\3" + bytes<std::int32_t>(2, 0, 1);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(error_of("a.ply", head + good + bytes(1.0F, nan, 3.0F) + good + face),
              "a.ply: vertex 1: coordinate nan is not finite");
    EXPECT_EQ(error_of("a.ply", head + good + good + bytes(1.0F, 2.0F, -inf) + face),
              "a.ply: vertex 2: coordinate -inf is not finite");
    EXPECT_EQ(error_of("a.ply", head + good + good + good + "\3" + bytes<std::int32_t>(2, 3, 1)),
              "a.ply: face 0: vertex index 3 out of range (3 vertices)");
    EXPECT_EQ(error_of("a.ply", head + good + good + good + "\3" + bytes<std::int32_t>(2, -1, 1)),
              "a.ply: face 0: vertex index -1 out of range (3 vertices)");
    const std::string doubles = header(
        format(), "element vertex 1\nproperty double x\nproperty double y\nproperty double z\n");
    EXPECT_EQ(error_of("a.ply", doubles + bytes(0.0, 1e39, 0.0)),
              "a.ply: vertex 0: coordinate 1e+39 is beyond the range of float");
}

TEST_P(LoadPlyBinary, RefusesHugeCountsWithoutHugeMemory) {
    const std::string point = bytes(1.0F, 2.0F, 3.0F);
    const std::string vertices = "property float x\nproperty float y\nproperty float z\n";
    const std::string head = header(format(), "element vertex 4294967295\n" + vertices);
    EXPECT_EQ(error_of("a.ply", head + point),
              "a.ply: file ends at byte " + std::to_string(head.size() + 12) +
                  ", after 1 of 4294967295 rows of element 'vertex'");
    EXPECT_NE(error_of("a.ply.gz", gzipped(head + point)), "");
    EXPECT_NE(error_of("a.ply",
                       header(format(), "element vertex 9223372036854775807\n" + vertices) + point),
              "");
    const std::string lists = "property list uint double a\n" + vertices;
    EXPECT_NE(error_of("a.ply", header(format(), "element vertex 1\n" + lists) +
                                    bytes<std::uint32_t>(4'294'967'295U) + point),
              "");
    const std::string faces = "element face 1\nproperty list uint int vertex_indices\n";
    EXPECT_NE(error_of("a.ply", header(format(), vertex3 + faces) + point + point + point +
                                    bytes<std::uint32_t>(4'294'967'295U) + std::string(400, '\0')),
              "");
}

TEST_P(LoadPlyBinary, RefusesNegativeListCounts) {
    const std::string lines = vertex3 + "element face 1\nproperty list char int vertex_indices\n";
    EXPECT_EQ(error_of("a.ply", header(format(), lines) + std::string(36, '\0') + "\xFF"),
              "a.ply: face 0: negative count -1 of list 'vertex_indices'");
}

TEST_P(LoadPlyBinary, CountsTrailingBytes) {
    const auto [mesh, report] =
        load("a.ply", header(format(), vertex3) + std::string(36, '\0') + "rest");
    EXPECT_EQ(report.trailing_byte_count, 4U);
}

TEST(LoadPly, WithoutFacesIsAPointCloud) {
    for (const std::string& lines :
         {vertex3, vertex3 + "element face 0\nproperty list uchar int vertex_indices\n"}) {
        const auto [mesh, report] = load("a.ply", ascii(lines, "0 0 0\n1 0 0\n1 0 0\n"));
        EXPECT_EQ(mesh.vertices.size(), 3U);
        EXPECT_TRUE(mesh.triangles.empty());
        EXPECT_EQ(report.duplicate_vertices.count, 1U);
        EXPECT_EQ(report.unused_vertices.count, 0U);
        EXPECT_EQ(report.format, "ply");
    }
}

TEST(LoadPly, CutsPolygonsAndCountsFacesOfFewCorners) {
    const auto [mesh, report] =
        load("a.ply", ascii("element face 4\nproperty list uchar int vertex_indices\n" + vertex3,
                            "4 0 1 2 0\n2 0 1\n0\n3 0 1 2\n" + rows3));
    EXPECT_THAT(mesh.triangles, ElementsAre(TriangleIndices{0, 1, 2}, TriangleIndices{0, 2, 0},
                                            TriangleIndices{0, 1, 2}));
    EXPECT_THAT(report.polygons.first, ElementsAre(0));
    EXPECT_THAT(report.degenerate_faces.first, ElementsAre(1, 2));
    EXPECT_EQ(report.face_count, 4U);
    EXPECT_EQ(error_of("a.ply", ascii(vertex3 + face1, rows3 + "2 0 1\n")),
              "a.ply: no faces of three or more corners");
}

TEST(LoadPly, UnrollsTriangleStrips) {
    const std::string lines =
        "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
        "element tristrips 1\nproperty list int int vertex_indices\n";
    const auto [mesh, report] = load("a.ply", ascii(lines,
                                                    "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n"
                                                    "12 0 1 2 3 4 -1 4 3 1 -1 0 1\n"));
    EXPECT_THAT(mesh.triangles, ElementsAre(TriangleIndices{0, 1, 2}, TriangleIndices{2, 1, 3},
                                            TriangleIndices{2, 3, 4}, TriangleIndices{4, 3, 1}));
    EXPECT_EQ(report.degenerate_faces.count, 1U);
}

TEST(LoadPly, NamesTheLineOfBadRows) {
    const auto error = [](const std::string& rows) {
        return error_of("a.ply", ascii(vertex3 + face1, rows));
    };
    EXPECT_EQ(error("0 0 0\n1 0\n"), "a.ply:11: row with too few numbers");
    EXPECT_EQ(error("0 0 0\n1 0 0 0\n"), "a.ply:11: unexpected '0' at the end of the row");
    EXPECT_EQ(error("0 0 0\n1 0 x\n"), "a.ply:11: malformed coordinate 'x'");
    EXPECT_EQ(error("0 0 0\n1 0 nan\n"), "a.ply:11: coordinate 'nan' is not finite");
    EXPECT_EQ(error("0 0 0\n1 0 1e39\n"),
              "a.ply:11: coordinate '1e39' is beyond the range of float");
    EXPECT_EQ(error("0 0 0\n1 0 0\n"), "a.ply:11: file ends after 2 of 3 rows of element 'vertex'");
    EXPECT_EQ(error(rows3), "a.ply:12: file ends after 0 of 1 rows of element 'face'");
    EXPECT_EQ(error(rows3 + "3 0 1\n"), "a.ply:13: row with too few numbers");
    EXPECT_EQ(error(rows3 + "3 0 1 3\n"), "a.ply:13: vertex index 3 out of range (3 vertices)");
    EXPECT_EQ(error(rows3 + "\n3 0 1 -1\n"), "a.ply:14: vertex index -1 out of range (3 vertices)");
    EXPECT_EQ(error(rows3 + "3 0 1 1.5\n"), "a.ply:13: malformed integer '1.5'");
    EXPECT_EQ(error(rows3 + "-3 0 1 2\n"), "a.ply:13: negative count -3 of list 'vertex_indices'");
    EXPECT_EQ(error_of("a.ply", ascii(vertex3 + "property uchar red\n", "0 0 0 red\n")),
              "a.ply:9: malformed number 'red'");
}

TEST(LoadPly, NamesTheLineOfABadHeader) {
    const auto error = [](const std::string& text) { return error_of("a.ply", text); };
    EXPECT_EQ(error("plyx\n"), "a.ply:1: not a PLY file: it does not begin with 'ply'");
    EXPECT_EQ(error("ply\nformat ascii 2.0\n"), "a.ply:2: unknown PLY format 'ascii 2.0'");
    EXPECT_EQ(error("ply\nformat binary 1.0\n"), "a.ply:2: unknown PLY format 'binary 1.0'");
    EXPECT_EQ(error("ply\nend_header\n"), "a.ply:2: PLY header without a format");
    EXPECT_EQ(error("ply\nformat ascii 1.0\nelement vertex 3\n"),
              "a.ply:3: PLY header without 'end_header'");
    EXPECT_EQ(error("ply\nvertices 3\n"), "a.ply:2: unknown word 'vertices' in the PLY header");
    for (const char* const count : {"-1", "x", "", "1.5", "99999999999999999999"}) {
        EXPECT_EQ(error(std::string("ply\nelement vertex ") + count + "\n"),
                  std::string("a.ply:2: malformed count '") + count + "' of PLY element 'vertex'");
    }
    EXPECT_EQ(error("ply\nproperty float x\n"), "a.ply:2: PLY property before any element");
    EXPECT_EQ(error("ply\nelement a 1\nproperty half x\n"), "a.ply:3: unknown PLY type 'half'");
    EXPECT_EQ(error("ply\nelement a 1\nproperty list float int x\n"),
              "a.ply:3: PLY list with a count that is not an integer");
    EXPECT_EQ(error("ply\nelement a 1\nproperty int\n"), "a.ply:3: PLY property without a name");
    EXPECT_EQ(error("ply\nelement a 1\nproperty int b\nproperty int b\n"),
              "a.ply:4: PLY property 'b' declared twice");
    EXPECT_EQ(error("ply\nelement a 1\nelement a 1\n"), "a.ply:3: PLY element 'a' declared twice");
}

TEST(LoadPly, RefusesElementsWithoutTheNeededProperties) {
    EXPECT_EQ(
        error_of("a.ply", ascii("element vertex 1\nproperty float x\nproperty float z\n", "0 0\n")),
        "a.ply:3: PLY element 'vertex' has no property 'y'");
    EXPECT_EQ(error_of("a.ply", ascii(vertex3 + "element face 1\nproperty int a\n", rows3 + "0\n")),
              "a.ply:7: PLY element 'face' has no list 'vertex_indices' of integers");
    EXPECT_EQ(
        error_of("a.ply", ascii(vertex3 + "element face 1\nproperty list int float vertex_index\n",
                                rows3 + "3 0 1 2\n")),
        "a.ply:7: PLY element 'face' has no list 'vertex_indices' of integers");
    EXPECT_EQ(error_of("a.ply", ascii(face1, "3 0 1 2\n")),
              "a.ply:6: vertex index 0 out of range (0 vertices)");
    EXPECT_EQ(error_of("a.ply", ascii("element vertex 0\nproperty float x\nproperty float y\n"
                                      "property float z\n",
                                      "")),
              "a.ply: no vertices");
}

TEST(LoadPly, RefusesDeclarationsWithoutEnd) {
    std::string lines = "element vertex 1\n";
    for (int i = 0; i < 2000; ++i) {
        lines += "property float p" + std::to_string(i) + "\n";
    }
    EXPECT_EQ(error_of("a.ply", ascii(lines, "")),
              "a.ply:1028: more than 1024 properties of a PLY element");
}

}  // namespace
}  // namespace coppice::test
