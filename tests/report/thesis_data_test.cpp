#include "report/thesis_data.h"

#include "coppice/base/error.h"

#include <gtest/gtest.h>

#include <string>

namespace coppice::report {
namespace {

const std::string header =
    "scene,primitive_count,sample_percent,sah_cost,build_seconds,node_count,max_level\n";

TEST(ThesisTables, HoldsElevenTreesOfFourScenes) {
    const ThesisTables& thesis = thesis_tables();
    EXPECT_EQ(thesis.rows.size(), 44U);
    ASSERT_EQ(thesis.scenes(),
              (std::vector<std::string>{"living_room", "bmw", "bistro", "dragon"}));
    for (const std::string& scene : thesis.scenes()) {
        for (const double percent : {100, 50, 40, 30, 20, 10, 5, 4, 3, 2, 1}) {
            EXPECT_NE(thesis.find(scene, percent), nullptr) << scene << " " << percent;
        }
    }
}

TEST(ThesisTables, HoldsThePublishedNumbers) {
    const ThesisRow* row = thesis_tables().find("dragon", 1);
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->primitive_count, 5'545'806);
    EXPECT_EQ(row->sah_cost, 49.1755);
    EXPECT_EQ(row->build_seconds, 6);
    EXPECT_EQ(row->node_count, 41'397);
    EXPECT_EQ(row->max_level, 16);
    const ThesisRow* room = thesis_tables().find("living_room", 50);
    ASSERT_NE(room, nullptr);
    EXPECT_EQ(room->sah_cost, 16.2415);
    EXPECT_EQ(room->build_seconds, 23);
}

TEST(ThesisTables, CostsRiseAndTimesFallAsTheThesisSays) {
    const ThesisTables& thesis = thesis_tables();
    for (std::size_t i = 1; i < thesis.rows.size(); ++i) {
        const ThesisRow& before = thesis.rows[i - 1];
        const ThesisRow& row = thesis.rows[i];
        if (before.scene != row.scene) continue;
        EXPECT_GT(row.sah_cost, before.sah_cost) << row.scene << " " << row.percent;
        EXPECT_LE(row.build_seconds, before.build_seconds) << row.scene << " " << row.percent;
    }
}

TEST(ParseThesisTables, SkipsCommentsAndNamesTheBadLine) {
    EXPECT_EQ(parse_thesis_tables("# source\n" + header + "a,1,100,2,3,4,5\n").rows.size(), 1U);
    EXPECT_TRUE(parse_thesis_tables("").rows.empty());
    for (const char* bad : {"a,1,100,2,3,4\n", "a,1,100,2,3,4,5,6\n", "a,1,x,2,3,4,5\n",
                            ",1,100,2,3,4,5\n", "a,1,100,2,3,4,5x\n"}) {
        try {
            (void)parse_thesis_tables("# source\n" + header + bad);
            ADD_FAILURE() << "accepted " << bad;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::parse);
            EXPECT_NE(std::string(error.what()).find(":3:"), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW((void)parse_thesis_tables("scene,cost\n"), Error);
}

TEST(ThesisSceneTitle, ReadsLikeAName) {
    EXPECT_EQ(thesis_scene_title("living_room"), "living room");
    EXPECT_EQ(thesis_scene_title("bmw"), "BMW");
}

}  // namespace
}  // namespace coppice::report
