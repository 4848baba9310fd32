#include "coppice/version.h"

#include <gtest/gtest.h>

#include <string>

namespace coppice::test {
namespace {

TEST(Version, IsThatOfTheHeaders) {
    EXPECT_EQ(version().major, COPPICE_VERSION_MAJOR);
    EXPECT_EQ(version().minor, COPPICE_VERSION_MINOR);
    EXPECT_EQ(version().patch, COPPICE_VERSION_PATCH);
    EXPECT_EQ(version().major * 10000 + version().minor * 100 + version().patch, COPPICE_VERSION);
}

TEST(Version, IsText) {
    const auto [major, minor, patch, text] = version();
    EXPECT_EQ(text,
              std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch));
}

}  // namespace
}  // namespace coppice::test
