#include "experiment/experiment_record.h"

#include "coppice/base/error.h"

#include "support/lab_scenes.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace coppice::lab {

namespace {

using test::TemporaryFolder;

TEST(ExperimentRecord, ContentIsOfTheBytes) {
    const TemporaryFolder folder;
    const FileContent empty = content_of(folder.make_file("empty", ""));
    EXPECT_EQ(empty.byte_count, 0U);
    EXPECT_EQ(empty.hash, "99aa06d3014798d86001c324468d497f");  // of xxhsum -H2 /dev/null
    std::string bytes(3'000'000, 'a');
    const FileContent same = content_of(folder.make_file("a", bytes));
    bytes.back() = 'b';
    EXPECT_NE(content_of(folder.make_file("b", bytes)), same);
    EXPECT_THROW(static_cast<void>(content_of(folder.path() / "none")), Error);
    EXPECT_THROW(static_cast<void>(content_of(folder.path())), Error);
}

TEST(ExperimentRecord, ComesBackFromItsFileAsItWas) {
    const TemporaryFolder folder;
    ExperimentOptions options;
    options.scenes = {folder.make_file("a.obj", "v 0 0 0\n")};
    options.methods = {"exact"};
    options.rays = {RayKind::diffuse};
    options.camera.up = Vec3f{0.1F, 0.2F, 0.3F};
    const ExperimentRecord record = record_of(options, {"coppice", "experiment"});
    const auto file = folder.make_file("record.json", nlohmann::json(record).dump());
    const ExperimentRecord loaded = load_record(file);
    EXPECT_EQ(nlohmann::json(loaded), nlohmann::json(record));
    EXPECT_TRUE(loaded.options.primitives.empty());
    EXPECT_TRUE(loaded.options.samplers.empty());
    EXPECT_EQ(loaded.options.camera.up, options.camera.up);
    EXPECT_NO_THROW(require_unchanged(loaded, "stop"));
    std::ofstream(options.scenes[0], std::ios::app) << "v 1 1 1\n";
    try {
        require_unchanged(loaded, "the run cannot be replayed");
        FAIL() << "did not throw";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("a.obj: the file has changed"));
        EXPECT_THAT(error.what(), testing::HasSubstr("cannot be replayed"));
    }
}

TEST(ExperimentRecord, RefusesOtherFiles) {
    const TemporaryFolder folder;
    for (const char* text : {"", "{", "[]", "{}", R"({"format": 9})"}) {
        EXPECT_THROW(static_cast<void>(load_record(folder.make_file("x.json", text))), Error);
    }
}

}  // namespace

}  // namespace coppice::lab
