#include "rows/output_folder.h"

#include "coppice/base/error.h"

#include "support/lab_scenes.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <array>

namespace coppice::lab {

namespace {

using test::TemporaryFolder;

constexpr std::array<std::string_view, 2> names{"a.txt", "b.txt"};

std::vector<OutputFile> two_files() {
    return {{"a.txt", "one"}, {"b.txt", "two"}};
}

TEST(OutputFolder, ChecksWithoutATrace) {
    const TemporaryFolder folder;
    check_writable(folder.path(), names);
    check_writable(folder.path() / "x" / "y" / "z", names);
    check_writable((folder.path() / "x").string() + "/", names);
    EXPECT_EQ(folder.listing(), "");
}

TEST(OutputFolder, WritesAllFilesAndMakesFolders) {
    const TemporaryFolder folder;
    write_all(folder.path() / "x" / "y", two_files());
    EXPECT_EQ(folder.listing(), "x\nx/y\nx/y/a.txt\nx/y/b.txt\n");
    EXPECT_EQ(test::read_file(folder.path() / "x/y/b.txt"), "two");
}

TEST(OutputFolder, ReplacesOldFiles) {
    const TemporaryFolder folder;
    static_cast<void>(folder.make_file("a.txt", "an old and longer one"));
    static_cast<void>(folder.make_file("other.txt", "kept"));
    write_all(folder.path(), two_files());
    EXPECT_EQ(test::read_file(folder.path() / "a.txt"), "one");
    EXPECT_EQ(folder.listing(), "a.txt\nb.txt\nother.txt\n");
}

TEST(OutputFolder, RefusesWhatIsNoFolder) {
    const TemporaryFolder folder;
    const auto file = folder.make_file("file", "x");
    EXPECT_THROW(check_writable(file, names), Error);
    EXPECT_THROW(check_writable(file / "below", names), Error);
    EXPECT_THROW(write_all(file / "below", two_files()), Error);
    EXPECT_EQ(folder.listing(), "file\n");
}

TEST(OutputFolder, RefusesWhereNothingCanBeMade) {
    EXPECT_THROW(check_writable("/proc/coppice/x", names), Error);
    EXPECT_THROW(write_all("/proc/coppice/x", two_files()), Error);
}

TEST(OutputFolder, RefusesAFolderInPlaceOfAFile) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "b.txt");
    EXPECT_THROW(check_writable(folder.path(), names), Error);
    EXPECT_EQ(folder.listing(), "b.txt\n");
}

TEST(OutputFolder, ReplacesWhatALinkLeadsTo) {
    const TemporaryFolder folder;
    static_cast<void>(folder.make_file("old.txt", "old"));
    std::filesystem::create_symlink("old.txt", folder.path() / "a.txt");
    check_file_writable(folder.path() / "a.txt");
    write_all(folder.path(), two_files());
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "a.txt"));
    EXPECT_EQ(test::read_file(folder.path() / "old.txt"), "one");
}

TEST(OutputFolder, FollowsALinkToWhatIsNotThereYet) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("new.txt", folder.path() / "a.txt");
    write_all(folder.path(), two_files());
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "a.txt"));
    EXPECT_EQ(test::read_file(folder.path() / "new.txt"), "one");
    std::filesystem::create_symlink("none/new.txt", folder.path() / "c.txt");
    EXPECT_THROW(check_file_writable(folder.path() / "c.txt"), Error);
    std::filesystem::create_symlink("d.txt", folder.path() / "d.txt");
    EXPECT_THROW(check_file_writable(folder.path() / "d.txt"), Error);
}

TEST(OutputFolder, RefusesToReplaceAPipe) {
    const TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder.path() / "b.txt").c_str(), 0600), 0);
    EXPECT_THROW(check_writable(folder.path(), names), Error);
    EXPECT_THROW(check_file_writable(folder.path() / "b.txt"), Error);
    EXPECT_THROW(write_all(folder.path(), two_files()), Error);
    EXPECT_TRUE(std::filesystem::is_fifo(folder.path() / "b.txt"));
    EXPECT_EQ(folder.listing(), "b.txt\n");
}

TEST(OutputFolder, WritesNoneIfOneCannotBeWritten) {
    const TemporaryFolder folder;
    const std::vector<OutputFile> files{{"a.txt", "one"}, {"no/such/b.txt", "two"}};
    EXPECT_THROW(write_all(folder.path() / "x", files), Error);
    EXPECT_EQ(folder.listing(), "");
}

}  // namespace

}  // namespace coppice::lab
