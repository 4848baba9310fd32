// How long it takes to stop a build, by every method, at random moments, and to open a saved tree.
// COPPICE_TIMES_SCENE=FILE takes a scene, COPPICE_TIMES_STOPS=N so many moments each; the limits
// are those of a machine that does other things, too, unless COPPICE_TIMES_LIMIT=MS is given.

#include "coppice/base/error.h"
#include "coppice/base/timer.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"
#include "coppice/io/load_mesh.h"
#include "coppice/store/tree_file.h"
#include "coppice/trace/bvh8_tracer.h"

#include "io/test_files.h"
#include "support/builds.h"
#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace coppice::test {
namespace {

double number_from(const char* variable, double otherwise) {
    const char* const text = std::getenv(variable);
    return text != nullptr ? std::atof(text) : otherwise;
}

const TriangleMesh& scene() {
    static const TriangleMesh mesh = [] {
        const char* const file = std::getenv("COPPICE_TIMES_SCENE");
        return file != nullptr ? load_mesh(file) : make_terrain(300, 1);
    }();
    return mesh;
}

double limit_milliseconds() {
    return number_from("COPPICE_TIMES_LIMIT", 2000.0);
}

void build(const Method& method, const BuildControl& control) {
    static_cast<void>(build_any(scene().view(), method.options(), control));
}

/// Milliseconds from a request, `after` so many seconds, to the end of the build; 0 if that came
/// first.
double stop_milliseconds(const Method& method, double after) {
    std::stop_source stop;
    Timer since_request;
    const std::jthread request([&] {
        std::this_thread::sleep_for(std::chrono::duration<double>(after));
        since_request.restart();
        stop.request_stop();
    });
    try {
        build(method, {.stop = stop.get_token()});
        return 0.0;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::cancelled);
        return 1000.0 * since_request.seconds();
    }
}

class StopTimes : public testing::TestWithParam<Method> {};

TEST_P(StopTimes, AreShortAtRandomMoments) {
    const Method& method = GetParam();
    const Timer timer;
    build(method, {});
    const double whole = timer.seconds();
    Random random(1);
    double longest = 0.0;
    const auto count = static_cast<int>(number_from("COPPICE_TIMES_STOPS", 3));
    for (int i = 0; i < count; ++i) {
        const double moment = static_cast<double>(random.below(1000)) / 1000.0;
        longest = std::max(longest, stop_milliseconds(method, moment * whole));
    }
    std::printf("%s: %.2f s, %d stops, the slowest took %.0f ms\n",
                std::string(method.name).c_str(), whole, count, longest);
    EXPECT_LE(longest, limit_milliseconds());
}

INSTANTIATE_TEST_SUITE_P(Method, StopTimes,
                         testing::ValuesIn(method_registry().begin(), method_registry().end()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(OpeningTime, ToTheFirstHitIsShort) {
    const std::filesystem::path file = fresh_folder() / "tree.cpk";
    const Fingerprint primitives = fingerprint_of(scene().view());
    save_tree(file, build_bvh8(scene().view(), {}).tree, primitives);
    double best = limit_milliseconds();
    for (int i = 0; i < 5; ++i) {
        const Timer timer;
        SavedTree saved = load_tree(file, primitives);
        const Bvh8Tracer tracer(std::get<Bvh8>(std::move(saved.tree)));
        const Aabb& box = tracer.tree().bounds();
        const Vec3f above{0.5F * box.lower.x + 0.5F * box.upper.x,
                          0.5F * box.lower.y + 0.5F * box.upper.y, box.upper.z + 1.0F};
        static_cast<void>(tracer.intersect({.origin = above, .direction = {0, 0, -1}}));
        best = std::min(best, 1000.0 * timer.seconds());
        std::printf("opened and traced in %.1f ms\n", 1000.0 * timer.seconds());
    }
    EXPECT_LT(best, limit_milliseconds());
    std::filesystem::remove_all(file.parent_path());
}

}  // namespace
}  // namespace coppice::test
