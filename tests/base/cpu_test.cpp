#include "coppice/base/cpu.h"

#include "coppice/base/error.h"

#include "support/isa.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <string>

namespace coppice::test {
namespace {

TEST(AvailableIsas, BeginWithTheOneThatAlwaysIs) {
    ASSERT_FALSE(available_isas().empty());
    EXPECT_EQ(available_isas().front(), Isa::scalar);
}

TEST(ChooseIsa, TakesTheFastestUnlessTold) {
    unsetenv("COPPICE_ISA");
    EXPECT_EQ(choose_isa(), available_isas().back());
    for (const Isa isa : available_isas()) {
        const ForceIsa force(isa);
        EXPECT_EQ(choose_isa(), isa);
    }
}

TEST(ChooseIsa, KnowsNamesInAnyCaseAndWithoutDots) {
    for (const Isa isa : available_isas()) {
        std::string name;
        for (const char c : name_of(isa)) {
            if (c != '.') name += static_cast<char>(std::toupper(c));
        }
        setenv("COPPICE_ISA", name.c_str(), 1);
        EXPECT_EQ(choose_isa(), isa) << name;
    }
    unsetenv("COPPICE_ISA");
}

TEST(ChooseIsa, RefusesWhatIsNotThere) {
    setenv("COPPICE_ISA", "mmx", 1);
    try {
        static_cast<void>(choose_isa());
        ADD_FAILURE() << "no exception";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        EXPECT_THAT(error.what(), testing::StartsWith("COPPICE_ISA is 'mmx'; set it to one of: "));
    }
    unsetenv("COPPICE_ISA");
}

}  // namespace
}  // namespace coppice::test
