#include "coppice/base/big_buffer.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <utility>

namespace coppice::test {
namespace {

TEST(BigBuffer, HoldsWhatIsWritten) {
    for (const std::size_t count : {std::size_t{1}, std::size_t{1000}, std::size_t{3} << 20U}) {
        BigBuffer buffer(count * sizeof(std::uint32_t));
        EXPECT_EQ(buffer.byte_count(), count * sizeof(std::uint32_t));
        const auto numbers = buffer.view<std::uint32_t>(0, count);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(numbers.data()) % 64, 0U);
        for (std::size_t i = 0; i < count; ++i) {
            numbers[i] = static_cast<std::uint32_t>(i);
        }
        const BigBuffer moved = std::move(buffer);
        EXPECT_EQ(moved.view<std::uint32_t>(0, count)[count - 1], count - 1);
    }
}

TEST(BigBuffer, KeepsTheBeginningWhenShrunk) {
    constexpr std::size_t size = std::size_t{9} << 20U;
    BigBuffer buffer(size);
    const auto bytes = buffer.view<unsigned char>(0, size);
    std::fill(bytes.begin(), bytes.end(), static_cast<unsigned char>(7));
    buffer.shrink(5'000'001);
    EXPECT_EQ(buffer.byte_count(), 5'000'001U);
    EXPECT_EQ(buffer.view<unsigned char>(0, 5'000'001)[5'000'000], 7);
    buffer.shrink(6'000'000);  // never grows
    EXPECT_EQ(buffer.byte_count(), 5'000'001U);
}

TEST(BigBuffer, OfNothingIsFine) {
    EXPECT_EQ(BigBuffer().byte_count(), 0U);
    EXPECT_EQ(BigBuffer(0).byte_count(), 0U);
}

TEST(BigBuffer, ThrowsWhenThereIsNoSuchMemory) {
    EXPECT_THROW(BigBuffer(SIZE_MAX), std::bad_alloc);
    EXPECT_THROW(BigBuffer(SIZE_MAX / 2), std::bad_alloc);
}

}  // namespace
}  // namespace coppice::test
