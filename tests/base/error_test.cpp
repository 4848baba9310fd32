#include "coppice/base/error.h"

#include <gtest/gtest.h>

#include <exception>

namespace coppice::test {
namespace {

TEST(Error, KeepsItsCodeAndMessage) {
    const Error error(ErrorCode::limit, "too many");
    EXPECT_EQ(error.code(), ErrorCode::limit);
    EXPECT_STREQ(error.what(), "too many");
}

TEST(Error, IsAStandardException) {
    try {
        throw Error(ErrorCode::io, "no such file");
    } catch (const std::exception& error) {
        EXPECT_STREQ(error.what(), "no such file");
        EXPECT_NE(dynamic_cast<const Error*>(&error), nullptr);
    }
}

TEST(Error, CodesHaveStableNames) {
    EXPECT_EQ(error_code_name(ErrorCode::invalid_argument), "invalid_argument");
    EXPECT_EQ(error_code_name(ErrorCode::io), "io");
    EXPECT_EQ(error_code_name(ErrorCode::parse), "parse");
    EXPECT_EQ(error_code_name(ErrorCode::unsupported), "unsupported");
    EXPECT_EQ(error_code_name(ErrorCode::limit), "limit");
    EXPECT_EQ(error_code_name(ErrorCode::cancelled), "cancelled");
    EXPECT_EQ(error_code_name(ErrorCode::out_of_memory), "out_of_memory");
    EXPECT_EQ(error_code_name(static_cast<ErrorCode>(99)), "unknown");
}

TEST(FileError, StartsWithTheFile) {
    const Error error = file_error(ErrorCode::io, "a b.obj", "no such file");
    EXPECT_EQ(error.code(), ErrorCode::io);
    EXPECT_STREQ(error.what(), "a b.obj: no such file");
}

TEST(FileError, NamesTheLine) {
    const Error error = file_error(ErrorCode::parse, "bunny.obj", 812, "face index 9 out of range");
    EXPECT_EQ(error.code(), ErrorCode::parse);
    EXPECT_STREQ(error.what(), "bunny.obj:812: face index 9 out of range");
}

TEST(FileError, TakesBracesAsTheyAre) {
    EXPECT_STREQ(file_error(ErrorCode::parse, "{}.obj", 1, "bad {token}").what(),
                 "{}.obj:1: bad {token}");
}

}  // namespace
}  // namespace coppice::test
