// Queries and builds from many threads at once, short enough to run under the thread sanitizer in
// every CI run. Links the core only. Eight threads are eight, also on a machine of fewer.

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"
#include "coppice/scene/scene.h"
#include "coppice/trace/brute_force.h"

#include "support/meshes.h"
#include "support/more_threads.h"

#include <gtest/gtest.h>

#include <functional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace coppice::test {
namespace {

constexpr int thread_count = 8;

void run_on_all(const std::function<void(int)>& work) {
    std::vector<std::jthread> threads;
    for (int thread = 0; thread < thread_count; ++thread) {
        threads.emplace_back([&work, thread] { work(thread); });
    }
}

std::vector<Ray> rays_through_soup() {
    std::vector<Ray> rays;
    for (int i = 0; i < 600; ++i) {
        const float x = static_cast<float>(i % 25) / 25;
        const float y = static_cast<float>(i / 25) / 24;
        rays.push_back({.origin = {x, y, -1}, .direction = {0.01F * x, -0.02F * y, 1}});
    }
    return rays;
}

TEST(Threads, QueryOneSceneAtOnce) {
    const MoreThreads allowed(thread_count);
    const TriangleMesh mesh = make_soup(600, 0.1F, 1);
    const Scene scene(mesh);
    const std::vector<Ray> rays = rays_through_soup();
    std::vector<Hit> expected;
    for (const Ray& ray : rays) {
        expected.push_back(brute_force_intersect(mesh.view(), ray).value_or(Hit{}));
    }
    run_on_all([&](int thread) {
        std::vector<Hit> hits(rays.size());
        scene.intersect(rays, hits, thread % 3);  // on all threads, on this one, on two
        EXPECT_EQ(hits, expected);
        for (std::size_t i = 0; i < rays.size(); i += 7) {
            EXPECT_EQ(scene.occluded(rays[i]), expected[i].is_hit());
            EXPECT_EQ(scene.nearest(rays[i].origin).is_found(), true);
        }
    });
}

class BuildAtOnce : public testing::TestWithParam<Method> {};

TEST_P(BuildAtOnce, GivesTheTreeOfOneThread) {
    const MoreThreads allowed(thread_count);
    const TriangleMesh mesh = make_soup(3000, 0.02F, 2);
    const Method& method = GetParam();
    const auto same_trees = [&](auto options, auto build) {
        options.threads = 1;
        const auto expected = build(options);
        options.threads = 3;
        run_on_all([&](int thread) {
            if (thread >= 3) return;
            EXPECT_TRUE(build(options) == expected);
        });
    };
    if (method.tree() == TreeKind::kd) {
        same_trees(method.kd_options(), [&](const KdOptions& options) {
            return build_kd_tree(mesh.view(), options).tree;
        });
    } else {
        Bvh8Options options = method.bvh8_options();
        options.sampled_from = 0;
        options.cell_size = 256;
        same_trees(options, [&](const Bvh8Options& each) {
            const Bvh8 tree = build_bvh8(mesh.view(), each).tree;
            const auto bytes = std::as_bytes(tree.nodes());
            return std::vector<std::byte>(bytes.begin(), bytes.end());
        });
    }
}

INSTANTIATE_TEST_SUITE_P(Method, BuildAtOnce,
                         testing::ValuesIn(method_registry().begin(), method_registry().end()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(Threads, StopABuildFromOutside) {
    const MoreThreads allowed(thread_count);
    const TriangleMesh mesh = make_soup(20'000, 0.02F, 3);
    std::stop_source stop;
    std::jthread stopper;
    BuildControl control{.stop = stop.get_token()};
    control.on_progress = [&](double done) {
        if (done > 0.2 && !stopper.joinable()) stopper = std::jthread([&] { stop.request_stop(); });
    };
    try {
        static_cast<void>(build_kd_tree(mesh.view(), {.threads = thread_count}, control));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::cancelled);
    }
    EXPECT_TRUE(stop.stop_requested());
}

}  // namespace
}  // namespace coppice::test
