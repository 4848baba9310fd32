#include "coppice/base/rng.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <unordered_set>

namespace coppice::test {
namespace {

static_assert(random_bits(1, 2) == random_bits(1, 2));
static_assert(random_unit(1, 2) < 1.0);

// Deviation of Pearson's statistic from its mean, in its standard deviations.
template <std::size_t bin_count>
double chi_square_deviation(const std::array<std::uint64_t, bin_count>& bins) {
    double total = 0.0;
    for (const std::uint64_t count : bins) {
        total += static_cast<double>(count);
    }
    const double expected = total / bin_count;
    double chi_square = 0.0;
    for (const std::uint64_t count : bins) {
        const double deviation = static_cast<double>(count) - expected;
        chi_square += deviation * deviation / expected;
    }
    const double freedom = bin_count - 1;
    return (chi_square - freedom) / std::sqrt(2.0 * freedom);
}

class RandomBits : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomBits, AreUniformOverCounters) {
    constexpr std::size_t bin_count = 256;
    std::array<std::array<std::uint64_t, bin_count>, 8> bins{};
    for (std::uint64_t counter = 0; counter < 100'000; ++counter) {
        const std::uint64_t bits = random_bits(GetParam(), counter);
        for (std::size_t byte = 0; byte < 8; ++byte) {
            ++bins[byte][bits >> (8 * byte) & 0xff];
        }
    }
    for (const auto& byte : bins) {
        EXPECT_LT(std::abs(chi_square_deviation(byte)), 5.0);
    }
}

TEST_P(RandomBits, AreUniformOverSeeds) {
    std::array<std::uint64_t, 256> bins{};
    for (std::uint64_t seed = 0; seed < 100'000; ++seed) {
        ++bins[random_bits(seed, GetParam()) >> 56];
    }
    EXPECT_LT(std::abs(chi_square_deviation(bins)), 5.0);
}

TEST_P(RandomBits, NeighborsAreIndependent) {
    // Pairs of successive numbers fill a 16 x 16 grid evenly; so do numbers of successive seeds.
    std::array<std::uint64_t, 256> of_counters{};
    std::array<std::uint64_t, 256> of_seeds{};
    for (std::uint64_t counter = 0; counter < 100'000; ++counter) {
        const std::uint64_t own = random_bits(GetParam(), counter) >> 60;
        ++of_counters[own << 4 | random_bits(GetParam(), counter + 1) >> 60];
        ++of_seeds[own << 4 | random_bits(GetParam() + 1, counter) >> 60];
    }
    EXPECT_LT(std::abs(chi_square_deviation(of_counters)), 5.0);
    EXPECT_LT(std::abs(chi_square_deviation(of_seeds)), 5.0);
}

TEST_P(RandomBits, ChangeByHalfWithEachBitOfTheInput) {
    for (unsigned bit = 0; bit < 64; ++bit) {
        int by_counter = 0;
        int by_seed = 0;
        for (std::uint64_t counter = 0; counter < 1000; ++counter) {
            const std::uint64_t bits = random_bits(GetParam(), counter);
            const std::uint64_t flip = std::uint64_t{1} << bit;
            by_counter += std::popcount(bits ^ random_bits(GetParam(), counter ^ flip));
            by_seed += std::popcount(bits ^ random_bits(GetParam() ^ flip, counter));
        }
        // 64,000 coins: a standard deviation of 126.
        EXPECT_NEAR(by_counter, 32'000, 700) << "bit " << bit;
        EXPECT_NEAR(by_seed, 32'000, 700) << "bit " << bit;
    }
}

TEST_P(RandomBits, DoNotRepeat) {
    std::unordered_set<std::uint64_t> seen;
    for (std::uint64_t counter = 0; counter < 50'000; ++counter) {
        seen.insert(random_bits(GetParam(), counter));
    }
    EXPECT_EQ(seen.size(), 50'000U);
}

TEST_P(RandomBits, UnitIsInRangeAndUniform) {
    double sum = 0.0;
    double squares = 0.0;
    constexpr int count = 100'000;
    for (std::uint64_t counter = 0; counter < count; ++counter) {
        const double unit = random_unit(GetParam(), counter);
        ASSERT_GE(unit, 0.0);
        ASSERT_LT(unit, 1.0);
        sum += unit;
        squares += unit * unit;
    }
    EXPECT_NEAR(sum / count, 1.0 / 2.0, 5.0 * std::sqrt(1.0 / 12.0 / count));
    EXPECT_NEAR(squares / count, 1.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / count));
}

INSTANTIATE_TEST_SUITE_P(Seed, RandomBits,
                         testing::Values(0U, 1U, 42U, 0x9e3779b97f4a7c15U, 0xffffffffffffffffU),
                         [](const auto& each) { return std::to_string(each.param); });

}  // namespace
}  // namespace coppice::test
