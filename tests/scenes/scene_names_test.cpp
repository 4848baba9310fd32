#include "scenes/scene_names.h"

#include <gmock/gmock.h>

namespace coppice::lab {

namespace {

using Files = std::vector<std::filesystem::path>;
using testing::ElementsAre;

TEST(SceneNames, WithoutFolderAndExtensions) {
    EXPECT_EQ(scene_name("scenes/dragon.obj"), "dragon");
    EXPECT_EQ(scene_name("motorBike.obj.gz"), "motorBike");
    EXPECT_EQ(scene_name("my.scene.v2.ply"), "my.scene.v2");
    EXPECT_EQ(scene_name("noextension"), "noextension");
    EXPECT_EQ(scene_name(".obj"), ".obj");
}

TEST(SceneNames, AreMadeUnique) {
    const Files files{"a/x.obj", "b/x.obj", "y.ply", "c/x.ply.gz"};
    EXPECT_THAT(scene_names(files), ElementsAre("x", "x-2", "y", "x-3"));
}

TEST(SceneNames, AnUnlikelyNameIsNotTakenTwice) {
    const Files files{"x.obj", "x-2.obj", "b/x.obj"};
    EXPECT_THAT(scene_names(files), ElementsAre("x", "x-2", "x-3"));
}

TEST(SceneNames, DefaultOutputFolder) {
    EXPECT_EQ(default_output_folder(Files{"scenes/dragon.obj"}), "out/dragon");
    EXPECT_EQ(default_output_folder(Files{"a.obj", "b.obj", "c.obj"}), "out/a-and-2-more");
}

}  // namespace

}  // namespace coppice::lab
