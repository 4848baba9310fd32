// Builds run on as many threads as they are given. No time is measured: the thread that tells of
// the progress waits a little, so that others can join if there is work for them.

#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"

#include "support/builds.h"
#include "support/meshes.h"
#include "support/more_threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#ifdef COPPICE_TEST_HAS_TBB

namespace coppice::test {
namespace {

class ThreadsOfABuild : public testing::TestWithParam<Method> {};

/// The most threads that took part in a build by a method on at most `threads` threads.
std::size_t threads_in_build(const Method& method, int threads) {
    static const TriangleMesh mesh = make_soup(30'000, 0.02F, 1);
    BuildOptions options = method.options();
    set_threads(options, threads);
    std::optional<ThreadsTakingPart> taking_part;
    std::size_t most = 0;
    const auto watch = [&](double done) {
        if (done == 0.0 || done == 1.0) return;  // before the tasks, or after them
        if (!taking_part) taking_part.emplace();
        const auto expected = static_cast<std::size_t>(threads);
        if (most < expected) most = std::max(most, taking_part->count(expected));
    };
    const BuildControl control{.on_progress = watch};
    static_cast<void>(build_any(mesh.view(), options, control));
    return most;
}

TEST_P(ThreadsOfABuild, AreAsManyAsItIsGiven) {
    const MoreThreads allowed(2);
    EXPECT_EQ(threads_in_build(GetParam(), 1), 1U);
    EXPECT_EQ(threads_in_build(GetParam(), 2), 2U);
}

INSTANTIATE_TEST_SUITE_P(Method, ThreadsOfABuild,
                         testing::ValuesIn(method_registry().begin(), method_registry().end()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace coppice::test

#endif
