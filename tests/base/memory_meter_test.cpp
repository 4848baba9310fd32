#include "coppice/base/memory_meter.h"

#include "coppice/base/parallel.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

constexpr std::uint64_t kilobytes = 1024;

TEST(MemoryMeter, KnowsTheMostThatWasHeldAtOnce) {
    MemoryMeter meter;
    EXPECT_EQ(meter.peak_bytes(), 0U);
    {
        const MeteredBytes first(&meter, 10 * kilobytes);
        EXPECT_EQ(meter.held_bytes(), 10 * kilobytes);
        { const MeteredBytes second(&meter, 20 * kilobytes); }
        const MeteredBytes third(&meter, 5 * kilobytes);
        EXPECT_EQ(meter.held_bytes(), 15 * kilobytes);
    }
    EXPECT_EQ(meter.held_bytes(), 0U);
    EXPECT_EQ(meter.peak_bytes(), 30 * kilobytes);
}

TEST(MeteredBytes, MoveWithTheirArray) {
    MemoryMeter meter;
    MeteredBytes first(&meter, 10 * kilobytes);
    MeteredBytes second = std::move(first);
    EXPECT_EQ(meter.held_bytes(), 10 * kilobytes);
    MeteredBytes third(&meter, 7 * kilobytes);
    third = std::move(second);
    EXPECT_EQ(meter.held_bytes(), 10 * kilobytes);
    third.release();
    third.release();
    EXPECT_EQ(meter.held_bytes(), 0U);
}

TEST(MeteredBytes, ReplaceEachOther) {
    MemoryMeter meter;
    MeteredBytes bytes(&meter, 10 * kilobytes);
    bytes = {&meter, 30 * kilobytes};
    EXPECT_EQ(meter.held_bytes(), 30 * kilobytes);
    bytes = {&meter, 20 * kilobytes};
    EXPECT_EQ(meter.held_bytes(), 20 * kilobytes);
}

TEST(MeteredBytes, CountTheCapacityOfAVector) {
    MemoryMeter meter;
    std::vector<double> array;
    array.reserve(1000);
    const MeteredBytes bytes(&meter, array);
    EXPECT_EQ(meter.held_bytes(), array.capacity() * sizeof(double));
}

TEST(MeteredBytes, DoWithoutAMeterAndLeaveSmallArraysOut) {
    MemoryMeter meter;
    const MeteredBytes unmetered(nullptr, 10 * kilobytes);
    const MeteredBytes small(&meter, MeteredBytes::least_bytes - 1);
    EXPECT_EQ(meter.peak_bytes(), 0U);
}

TEST(MeteredBytes, AreCountedFromSeveralThreads) {
    MemoryMeter meter;
    run_with_threads(0, [&] {
        parallel_for_chunks(1000, 10, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const MeteredBytes bytes(&meter, 8 * kilobytes);
            }
        });
    });
    EXPECT_EQ(meter.held_bytes(), 0U);
    EXPECT_GE(meter.peak_bytes(), 8 * kilobytes);
    EXPECT_LE(meter.peak_bytes(), 8 * kilobytes * static_cast<unsigned>(hardware_thread_count()));
}

}  // namespace
}  // namespace coppice::test
