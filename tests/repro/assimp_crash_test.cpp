// Assimp 5.2.5 read beyond its arrays where these files are damaged, and took the program with it.
// It runs in a process of its own now: docs/decisions/0007.

#include "io/test_files.h"

#include <gmock/gmock.h>

namespace coppice::test {
namespace {

// Faces of vertices that no list has.
TEST(AssimpCrash, InAseIsAnError) {
    const std::string error =
        error_of("a.ase",
                 "*3DSMAX_ASCIIEXPORT 200\n*GEOMOBJECT {\n *MESH {\n  *MESH_NUMVERTEX 3\n"
                 "  *MESH_NUMFACES 1\n  *MESH_FACE_LIST { *MESH_FACE 0: A: 0 B: 1 C: 2 }\n }\n}\n");
    EXPECT_THAT(error, testing::StartsWith("a.ase: Assimp "));
    EXPECT_THAT(error, testing::EndsWith(": the file is damaged"));
}

// An array whose number of elements is not told: how far one may read beyond it is a matter of
// luck.
TEST(AssimpCrash, InColladaIsNotOurs) {
    std::string text = read_file(data_file("tetrahedron.dae"));
    text.replace(text.find(" count=\"12\""), 11, " coun=\"12\"");
    static_cast<void>(error_of("a.dae", text));
    EXPECT_EQ(error_of_file(data_file("tetrahedron.dae"), ErrorCode::parse), "");
}

}  // namespace
}  // namespace coppice::test
