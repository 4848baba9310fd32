#include "coppice/io/write_file.h"

#include "io/new_file.h"
#include "io/test_files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

namespace coppice::test {
namespace {

std::ptrdiff_t entry_count(const std::filesystem::path& folder) {
    return std::distance(std::filesystem::directory_iterator(folder), {});
}

/// What write_file says, without the folder; "" if it writes.
std::string write_error(const std::filesystem::path& file, std::string_view contents) {
    try {
        write_file(file, contents);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::io);
        return std::string(error.what()).substr(file.parent_path().string().size() + 1);
    }
    return "";
}

/// While it lives, no file of this process can pass `bytes`: a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &old_limit_);
        const rlimit limit{bytes, old_limit_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }

    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &old_limit_);
        static_cast<void>(std::signal(SIGXFSZ, old_handler_));
    }

    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    void (*old_handler_)(int);
    rlimit old_limit_{};
};

TEST(WriteFile, WritesAllBytes) {
    const std::filesystem::path file = fresh_folder() / "a.bin";
    const std::string contents("one\0two\n", 8);
    write_file(file, contents);
    EXPECT_EQ(read_file(file), contents);
    write_file(file, "");
    EXPECT_EQ(read_file(file), "");
    EXPECT_EQ(entry_count(file.parent_path()), 1);
}

TEST(WriteFile, TakesANameWithoutAFolderAndOneOfGreatestLength) {
    const std::filesystem::path folder = fresh_folder();
    write_file(folder / std::string(255, 'n'), "x");
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder);
    write_file("plain", "y");
    std::filesystem::current_path(before);
    EXPECT_EQ(read_file(folder / "plain"), "y");
    EXPECT_EQ(entry_count(folder), 2);
}

TEST(WriteFile, RefusesWhatItCannotReplace) {
    const std::filesystem::path folder = fresh_folder();
    EXPECT_EQ(write_error(folder / "none" / "a", "x"),
              "a: cannot write: No such file or directory");
    std::filesystem::create_directory(folder / "sub");
    EXPECT_EQ(write_error(folder / "sub", "x"), "sub: is a directory, not a file");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(write_error(folder / "pipe", "x"), "pipe: not a regular file");
    EXPECT_EQ(write_error("/dev/null", "x"), "null: not a regular file");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    EXPECT_EQ(entry_count(folder), 2);
}

TEST(WriteFile, RefusesAFolderThatMayNotBeWritten) {
    const std::filesystem::path file = make_file("a.txt", "old");
    std::filesystem::permissions(file.parent_path(), std::filesystem::perms::owner_write,
                                 std::filesystem::perm_options::remove);
    {
        const WithoutRights without_rights;
        EXPECT_EQ(write_error(file, "new"), "a.txt: cannot write: Permission denied");
    }
    EXPECT_EQ(read_file(file), "old");
}

TEST(WriteFile, OnAFullDiskKeepsTheOldFileAndNoTemporaryOne) {
    const std::filesystem::path file = make_file("a.txt", "old");
    for (const std::size_t size : {std::size_t{2000}, std::size_t{10'000'000}}) {
        const FullDisk full_disk(1000);
        EXPECT_EQ(write_error(file, std::string(size, 'x')), "a.txt: cannot write: File too large");
    }
    EXPECT_EQ(read_file(file), "old");
    EXPECT_EQ(entry_count(file.parent_path()), 1);
}

TEST(WriteFile, WritesThroughASymbolicLink) {
    const std::filesystem::path file = make_file("a.txt", "old");
    const std::filesystem::path link = fresh_folder() / "link.txt";
    std::filesystem::create_symlink(file, link);
    write_file(link, "new");
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(read_file(file), "new");
}

TEST(NewFile, WithoutCommitLeavesNothing) {
    const std::filesystem::path file = make_file("a.txt", "old");
    {
        NewFile output(file);
        output.write("new");
        EXPECT_EQ(entry_count(file.parent_path()), 2);
        EXPECT_EQ(read_file(file), "old");
    }
    EXPECT_EQ(entry_count(file.parent_path()), 1);
    EXPECT_EQ(read_file(file), "old");
}

}  // namespace
}  // namespace coppice::test
