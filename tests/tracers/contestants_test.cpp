// Every contestant, ours and peers, finds what brute force finds.

#include "coppice/trace/brute_force.h"

#include "scenes/procedural.h"
#include "scenes/ray_sets.h"
#include "tracers/contestant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace coppice::lab {

namespace {

using MakeContestant = std::function<std::unique_ptr<Contestant>(int threads)>;

struct Case {
    std::string name;
    bool is_peer;
    MakeContestant make;
};

std::vector<Case> all_contestants() {
    std::vector<Case> cases;
    for (const Method& method : method_registry()) {
        cases.push_back({std::string(method.name), false, [&](int threads) {
                             return make_contestant(find_variant(method.name), threads);
                         }});
    }
    for (const Peer& peer : peer_registry()) {
        cases.push_back({std::string(peer.name), true, peer.make});
    }
    return cases;
}

class Contestants : public testing::TestWithParam<Case> {};

TEST_P(Contestants, FindWhatBruteForceFinds) {
    const TriangleMesh mesh = make_procedural("spheres", 600, 2);
    const auto camera = render::frame_box(bounds_of(mesh.vertices), {}, 1.0);
    const std::vector<Ray> rays = primary_rays(camera, 24);
    for (const int threads : {1, 2}) {
        const auto contestant = GetParam().make(threads);
        for (int run = 0; run < 2; ++run) {
            const BuildFigures figures = contestant->build(mesh.view(), run == 0);
            EXPECT_GT(figures.wall_seconds, 0.0);
            EXPECT_GE(figures.cpu_seconds, 0.0);
            EXPECT_GT(figures.bytes, 600U);
            EXPECT_GE(figures.peak_bytes, figures.bytes);
            EXPECT_EQ(figures.sah_cost.has_value(), !GetParam().is_peer);
            EXPECT_EQ(figures.reference_count.has_value(), !GetParam().is_peer);
            std::vector<Hit> hits(rays.size());
            std::vector<std::uint8_t> flags(rays.size());
            const Queries queries = run == 0 ? Queries::single : Queries::batched;
            contestant->intersect(rays, hits, queries);
            contestant->occluded(rays, flags, queries);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const auto expected = brute_force_intersect(mesh.view(), rays[i]);
                ASSERT_EQ(std::isfinite(hits[i].t), expected.has_value()) << "ray " << i;
                EXPECT_EQ(flags[i], expected ? 1 : 0);
                const float t = expected ? expected->t : hits[i].t;
                EXPECT_TRUE(hits[i].t == t || std::abs(hits[i].t - t) <= 1e-5F * t) << "ray " << i;
            }
            contestant->clear();
        }
        contestant->clear();
    }
}

TEST_P(Contestants, KeepToTheEndsOfRays) {
    const TriangleMesh wall{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    const auto contestant = GetParam().make(1);
    static_cast<void>(contestant->build(wall.view(), true));
    const std::vector<Ray> rays{{{0, 0, 5}, {0, 0, -5}, 0.0F, 1.5F},
                                {{0, 0, 5}, {0, 0, -5}, 0.0F, 0.5F},
                                {{0, 0, 5}, {0, 0, -5}, 1.5F, 9.0F},
                                {{0, 0, 5}, {0, 0, 5}}};
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> flags(rays.size());
    for (const Queries queries : {Queries::single, Queries::batched, Queries::coherent}) {
        contestant->intersect(rays, hits, queries);
        contestant->occluded(rays, flags, queries);
        EXPECT_EQ(flags, (std::vector<std::uint8_t>{1, 0, 0, 0}));
        EXPECT_NEAR(hits[0].t, 1.0F, 1e-6F);
        for (std::size_t i = 1; i < hits.size(); ++i) {
            EXPECT_TRUE(std::isinf(hits[i].t));
        }
    }
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
    std::string name = info.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, Contestants, testing::ValuesIn(all_contestants()), case_name);

}  // namespace

}  // namespace coppice::lab
