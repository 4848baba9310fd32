// In sound trees validate() missed triangles in leaves they pass by: clipped to boxes smaller than
// the rounding of their own coordinates, they seemed to be inside. Found by fuzzing.

#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"
#include "coppice/tree/validate.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(LongNeedle, IsNotMissedInLeavesItPassesBy) {
    // Its z leaves the soup's where its x is not yet in it.
    const TriangleMesh needle = make_triangle({Vec3f{0x1.e84e7ep+57F, 0x1.aap+5F, 0x1.997b0ep+111F},
                                               {-0x1.23p+5F, 0x1.24a126p+16F, -0x1.47476ep+20F},
                                               {-0x1.94p+5F, 0x1.39p+5F, -0x1.4747ap+20F}});
    const TriangleMesh soup = scaled(make_soup(200, 0.2F, 5), 0x1.0p17F);
    const TriangleMesh mesh = joined(soup, needle);
    for (const char* method : {"exact", "binned", "adaptive", "sweep"}) {
        KdOptions options = find_method(method).kd_options();
        options.split.max_leaf = 3;
        const auto findings = validate(build_kd_tree(mesh.view(), options).tree, mesh.view());
        EXPECT_TRUE(findings.empty()) << method << ": " << findings[0].message;
    }
}

}  // namespace
}  // namespace coppice::test
