#include "coppice/base/parallel.h"

#include "coppice/base/error.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <mutex>
#include <set>
#include <stdexcept>
#include <stop_token>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace coppice::test {
namespace {

using Range = std::pair<std::size_t, std::size_t>;

// The chunks that parallel_for_chunks() hands out, in order of their begin.
std::vector<Range> chunks_of(std::size_t count, std::size_t chunk_size) {
    std::mutex mutex;
    std::vector<Range> chunks;
    parallel_for_chunks(count, chunk_size, [&](std::size_t begin, std::size_t end) {
        const std::scoped_lock lock(mutex);
        chunks.emplace_back(begin, end);
    });
    std::sort(chunks.begin(), chunks.end());
    return chunks;
}

// The most calls of a task that ran at the same time, and the number of threads they ran on.
struct Concurrency {
    int most_at_once = 0;
    std::size_t thread_count = 0;
};

Concurrency concurrency_within(int thread_limit) {
    std::atomic<int> running = 0;
    std::mutex mutex;
    Concurrency seen;
    std::set<std::thread::id> threads;
    run_with_threads(thread_limit, [&] {
        parallel_for_chunks(64, 1, [&](std::size_t, std::size_t) {
            const int at_once = ++running;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            const std::scoped_lock lock(mutex);
            seen.most_at_once = std::max(seen.most_at_once, at_once);
            threads.insert(std::this_thread::get_id());
            --running;
        });
    });
    seen.thread_count = threads.size();
    return seen;
}

TEST(HardwareThreadCount, IsPositive) {
    EXPECT_GE(hardware_thread_count(), 1);
    EXPECT_TRUE(hardware_thread_count() == 1 || tasking_backend() != std::string_view("serial"));
}

TEST(ParallelForChunks, CoversEverythingOnce) {
    EXPECT_TRUE(chunks_of(0, 10).empty());
    EXPECT_EQ(chunks_of(1, 10), (std::vector<Range>{{0, 1}}));
    EXPECT_EQ(chunks_of(10, 10), (std::vector<Range>{{0, 10}}));
    EXPECT_EQ(chunks_of(25, 10), (std::vector<Range>{{0, 10}, {10, 20}, {20, 25}}));
    EXPECT_EQ(chunks_of(1000, 1).size(), 1000U);
}

TEST(ParallelForChunks, HasTheSameChunksForAnyThreadCount) {
    const std::vector<Range> expected = chunks_of(12'345, 100);
    for (const int threads : {1, 2, 3, 8}) {
        run_with_threads(threads, [&] { EXPECT_EQ(chunks_of(12'345, 100), expected); });
    }
}

TEST(ParallelForChunks, PassesExceptionsOn) {
    const auto run = [] {
        parallel_for_chunks(1000, 1, [](std::size_t begin, std::size_t) {
            if (begin == 777) throw Error(ErrorCode::limit, "chunk 777");
        });
    };
    try {
        run();
        FAIL() << "no exception";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::limit);
        EXPECT_STREQ(error.what(), "chunk 777");
    }
}

TEST(ParallelInvoke, RunsBothTasks) {
    std::atomic<int> sum = 0;
    parallel_invoke([&] { sum += 1; }, [&] { sum += 10; });
    EXPECT_EQ(sum, 11);
}

TEST(ParallelInvoke, Nests) {
    std::atomic<int> leaves = 0;
    const std::function<void(int)> split = [&](int depth) {
        if (depth == 0) {
            ++leaves;
            return;
        }
        parallel_invoke([&] { split(depth - 1); }, [&] { split(depth - 1); });
    };
    run_with_threads(2, [&] { split(12); });
    EXPECT_EQ(leaves, 4096);
}

TEST(ParallelInvoke, PassesExceptionsOn) {
    const auto fail = [] { throw std::out_of_range("task"); };
    const auto succeed = [] {};
    EXPECT_THROW(parallel_invoke(fail, succeed), std::out_of_range);
    EXPECT_THROW(parallel_invoke(succeed, fail), std::out_of_range);
    EXPECT_THROW(parallel_invoke(fail, fail), std::out_of_range);
}

TEST(RunWithThreads, KeepsToItsLimit) {
    for (const int limit : {1, 2, 3}) {
        const Concurrency seen = concurrency_within(limit);
        EXPECT_LE(seen.most_at_once, limit);
        EXPECT_TRUE(limit > 1 || seen.thread_count == 1U);
    }
}

TEST(RunWithThreads, UsesAllThreadsForZero) {
    EXPECT_LE(concurrency_within(0).most_at_once, hardware_thread_count());
}

TEST(RunWithThreads, LimitsAnOuterRunFurther) {
    run_with_threads(2, [] { EXPECT_EQ(concurrency_within(1).most_at_once, 1); });
}

TEST(RunWithThreads, RunsOnceAndReturnsAfterwards) {
    int runs = 0;
    run_with_threads(3, [&] { ++runs; });
    EXPECT_EQ(runs, 1);
}

TEST(RunWithThreads, RefusesFewerThanNone) {
    try {
        run_with_threads(-1, [] { FAIL() << "it ran"; });
        FAIL() << "it returned";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        EXPECT_STREQ(error.what(), "threads must be 0 (all) or more, not -1");
    }
}

TEST(RunWithThreads, PassesExceptionsOn) {
    for (const int threads : {0, 1, 2}) {
        EXPECT_THROW(run_with_threads(threads, [] { throw Error(ErrorCode::io, "work"); }), Error);
    }
}

/// The code of the Error that `work` throws.
ErrorCode code_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.code();
    }
    ADD_FAILURE() << "no error";
    return {};
}

TEST(RunWithThreads, DoesNotBeginOnceStopped) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(code_of([&] {
                  run_with_threads(
                      2, [] { FAIL() << "it ran"; }, stop.get_token());
              }),
              ErrorCode::cancelled);
}

TEST(RunWithThreads, StopsWhatIsInside) {
    for (const int threads : {1, 2}) {
        std::stop_source stop;
        std::atomic<int> chunks = 0;
        const auto work = [&] {
            parallel_for_chunks(100'000, 1, [&](std::size_t, std::size_t) {
                ++chunks;
                stop.request_stop();
            });
            FAIL() << "it went on";
        };
        EXPECT_EQ(code_of([&] { run_with_threads(threads, work, stop.get_token()); }),
                  ErrorCode::cancelled);
        EXPECT_LT(chunks, 100'000);
    }
}

TEST(RunWithThreads, StopsTasksOfTasks) {
    std::stop_source stop;
    const auto inner = [&] {
        stop.request_stop();
        throw_if_cancelled();
        FAIL() << "it went on";
    };
    EXPECT_EQ(code_of([&] {
                  run_with_threads(
                      1, [&] { parallel_invoke(inner, inner); }, stop.get_token());
              }),
              ErrorCode::cancelled);
    throw_if_cancelled();  // outside there is nothing to stop
}

class ParallelSort : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ParallelSort, SortsAsStdSort) {
    Random random(GetParam());
    for (const std::size_t count : {0U, 1U, 2U, 499U, 500U, 20'000U}) {
        std::vector<std::uint64_t> values(count);
        for (std::uint64_t& value : values) {
            value = (std::uint64_t{random.below(1U << 31)} << 32) + random.below(1U << 31);
        }
        std::vector<std::uint64_t> expected = values;
        std::sort(expected.begin(), expected.end());
        parallel_sort(values);
        EXPECT_EQ(values, expected);
    }
}

TEST_P(ParallelSort, SortsDuplicates) {
    Random random(GetParam());
    std::vector<std::uint64_t> values(5000);
    for (std::uint64_t& value : values) {
        value = random.below(3);
    }
    parallel_sort(values);
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
}

INSTANTIATE_TEST_SUITE_P(Seed, ParallelSort, testing::Values(1U, 2U, 3U),
                         [](const auto& each) { return std::to_string(each.param); });

}  // namespace
}  // namespace coppice::test
