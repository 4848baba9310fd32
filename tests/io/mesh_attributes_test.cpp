#include "coppice/io/mesh_attributes.h"

#include "coppice/io/load_mesh.h"

#include "io/test_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice {

namespace {

using test::make_file;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint32_t none = MeshAttributes::none;

MeshAttributes attributes_of(const std::filesystem::path& file) {
    MeshAttributes attributes;
    static_cast<void>(load_mesh(file, nullptr, &attributes));
    return attributes;
}

TEST(MeshAttributes, OfObjAreNormalsAndMaterialsByTriangle) {
    const auto file = make_file("a.obj",
                                "mtllib my lib.mtl\n"
                                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                "f 1 2 3\n"
                                "usemtl  dark red \n"
                                "vn 0 0 1\nvn 0 1 0\n"
                                "f 1//1 2//-1 3//1 4\n"  // two triangles
                                "usemtl lamp\nf 1/1/9 2/1/1 3\n"
                                "f 1 2\n"  // no triangle
                                "usemtl dark red\nf 1 2 3\n");
    std::ofstream(file.parent_path() / "my lib.mtl")
        << "newmtl lamp\nKe 1e1 2 3 # bright\n\nnewmtl dark red\r\nKd 0.5\nKs 1 0 0.5\nNs 30\n"
           "illum 3\nTr 1\n";
    const MeshAttributes attributes = attributes_of(file);
    EXPECT_THAT(attributes.triangle_materials, ElementsAre(none, 0, 0, 1, 0));
    ASSERT_EQ(attributes.materials.size(), 2U);
    EXPECT_EQ(attributes.materials[0].name, "dark red");
    EXPECT_EQ(attributes.materials[0].diffuse, (Vec3f{0.5F, 0.5F, 0.5F}));
    EXPECT_EQ(attributes.materials[0].specular, (Vec3f{1.0F, 0.0F, 0.5F}));
    EXPECT_EQ(attributes.materials[0].shininess, 30.0F);
    EXPECT_EQ(attributes.materials[0].illumination, 3);
    EXPECT_EQ(attributes.materials[1].emission, (Vec3f{10.0F, 2.0F, 3.0F}));
    EXPECT_EQ(attributes.materials[1].diffuse, Material().diffuse);
    EXPECT_THAT(attributes.normals, ElementsAre(Vec3f{0, 0, 1}, Vec3f{0, 1, 0}));
    EXPECT_THAT(attributes.triangle_normals,
                ElementsAre(TriangleIndices{none, none, none}, TriangleIndices{0, 1, 0},
                            TriangleIndices{0, 0, none}, TriangleIndices{none, 0, none},
                            TriangleIndices{none, none, none}));
    EXPECT_THAT(attributes.warnings, ElementsAre(HasSubstr("1 corners with normals out of range")));
}

TEST(MeshAttributes, WithoutLibraryAreGreyWithOneWarning) {
    constexpr const char* shape =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n";
    const MeshAttributes missing =
        attributes_of(make_file("a.obj", std::string("mtllib lost.mtl\n") + shape));
    EXPECT_THAT(missing.warnings,
                ElementsAre(HasSubstr("lost.mtl: no such file; its materials are grey")));
    EXPECT_EQ(missing.materials[1].diffuse, Material().diffuse);
    EXPECT_THAT(missing.triangle_materials, ElementsAre(0, 1));
    EXPECT_THAT(missing.normals, IsEmpty());
    EXPECT_THAT(missing.triangle_normals, IsEmpty());
    EXPECT_THAT(attributes_of(make_file("a.obj", shape)).warnings,
                ElementsAre(HasSubstr("2 of 2 materials are not defined in any material file")));
}

TEST(MeshAttributes, OfAMalformedLibraryKeepTheirDefaults) {
    const auto file = make_file("a.obj",
                                "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\n"
                                "usemtl a\nvn x 0 nan\nf 1//1 2//1 3//1\n");
    std::ofstream(file.parent_path() / "a.mtl")
        << "Kd 1 1 1\nnewmtl a\nKd 1 x 1\nKs 1 1\nKe -1 0 0\nNs inf\nillum 99\nmap_Kd wood.png\n";
    const MeshAttributes attributes = attributes_of(file);
    const Material& material = attributes.materials.at(0);
    EXPECT_EQ(material.diffuse, Material().diffuse);
    EXPECT_EQ(material.specular, Vec3f());
    EXPECT_EQ(material.emission, Vec3f());
    EXPECT_EQ(material.illumination, 1);
    EXPECT_THAT(attributes.warnings,
                ElementsAre(HasSubstr("a.obj: 1 malformed numbers in normals"),
                            HasSubstr("a.mtl:3: malformed Kd '1 x 1'"), HasSubstr("a.mtl:4: "),
                            HasSubstr("a.mtl:5: "), HasSubstr("a.mtl:6: "), HasSubstr("a.mtl:7: "),
                            HasSubstr("a.mtl: 1 textures are not read")));
}

TEST(MeshAttributes, OfPlyAreTheNormalsOfVertices) {
    const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float nz\n";
    const std::string tail =
        "property float x\nproperty float y\nproperty float z\nproperty float nx\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const MeshAttributes attributes = attributes_of(
        make_file("b.ply", head + "property double ny\n" + tail +
                               "1 0 0 0 0 0.5\n0 1 1 0 0 2\n1 nan 0 1 0 0\n3 0 1 2\n"));
    EXPECT_EQ(attributes.normals.size(), 3U);
    EXPECT_EQ(attributes.normals[0], (Vec3f{0.5F, 0.0F, 1.0F}));
    EXPECT_EQ(attributes.normals[1], (Vec3f{2.0F, 1.0F, 0.0F}));
    EXPECT_TRUE(std::isnan(attributes.normals[2].y));
    EXPECT_THAT(attributes.triangle_normals, IsEmpty());
    // Two of three are none.
    EXPECT_THAT(attributes_of(make_file("c.ply", head + tail +
                                                     "1 0 0 0 1\n1 1 0 0 1\n1 1 1 0 1\n"
                                                     "3 0 1 2\n"))
                    .normals,
                IsEmpty());
}

TEST(MeshAttributes, OfOtherFormatsComeFromAssimp) {
    if (!can_load_scene_files()) GTEST_SKIP() << "built without Assimp";
    const MeshAttributes attributes =
        attributes_of(make_file("a.stl",
                                "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"));
    ASSERT_EQ(attributes.normals.size(), 3U);
    EXPECT_EQ(attributes.normals[2], (Vec3f{0.0F, 0.0F, 1.0F}));
    EXPECT_THAT(attributes.triangle_materials, ElementsAre(0));
    EXPECT_THAT(attributes.materials, testing::SizeIs(1));
}

}  // namespace

}  // namespace coppice
