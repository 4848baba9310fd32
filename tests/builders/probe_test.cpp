#include "builders/probe.h"

#include "coppice/geom/triangle_mesh.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(Probe, OfEveryPieceHasEveryPrimitiveOnce) {
    const TriangleMesh mesh = make_soup(20000, 0.05F, 1);
    const TriangleMeshView view = mesh.view();
    const Probe probe = take_probe(view, 512, 1);
    EXPECT_EQ(probe.centers().size(), 20000U);
    EXPECT_GT(probe.size(), 20000U) << "triangles across a border are in several pieces";
}

TEST(Probe, TakesItsShareOfTheScene) {
    const TriangleMesh mesh = make_terrain(200, 1);
    const TriangleMeshView view = mesh.view();
    const Probe probe = take_probe(view, 512, 16);
    const double share =
        static_cast<double>(probe.centers().size()) / static_cast<double>(mesh.triangles.size());
    EXPECT_NEAR(share, 1.0 / 16.0, 0.02);
    const Probe thinned = probe.thinned(4);
    EXPECT_NEAR(static_cast<double>(thinned.size()) / probe.size(), 0.25, 0.1);
}

TEST(Probe, PartsStayWithinTheirPieces) {
    const TriangleMesh mesh = make_soup(5000, 0.2F, 2);
    const TriangleMeshView view = mesh.view();
    const Probe probe = take_probe(view, 512, 8);
    const Aabb everywhere{{-9, -9, -9}, {9, 9, 9}};
    for (std::uint32_t id = 0; id < probe.size(); ++id) {
        const Aabb box = probe.bounds(id);
        EXPECT_FALSE(box.is_empty());
        EXPECT_EQ(probe.clipped_bounds(id, everywhere), box);
        EXPECT_TRUE(probe.clipped_bounds(id, {{8, 8, 8}, {9, 9, 9}}).is_empty());
    }
}

}  // namespace
}  // namespace coppice::test
