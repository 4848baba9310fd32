#include "rows/machine.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace coppice::lab {

namespace {

TEST(Machine, IsFoundOut) {
    const Machine machine = find_machine();
    EXPECT_FALSE(machine.cpu.empty());
    EXPECT_GE(machine.cores, 1);
    EXPECT_GT(machine.memory_bytes, 0U);
    EXPECT_FALSE(machine.os.empty());
    EXPECT_EQ(machine.kernel.substr(0, 5), "Linux");
    EXPECT_EQ(nlohmann::json(machine).size(), 5U);
}

TEST(Machine, BuildIsStamped) {
    EXPECT_EQ(coppice_version(), "0.1.0");
    EXPECT_NE(compiler_name(), "unknown");
    EXPECT_NE(build_type(), "unknown");
    EXPECT_FALSE(git_revision().empty());
}

}  // namespace

}  // namespace coppice::lab
