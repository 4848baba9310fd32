#include "coppice/scene/point_scene.h"

#include "coppice/builders/build_tree.h"

#include <algorithm>
#include <utility>

namespace coppice::inline v0 {
namespace {

constexpr std::uint32_t crowded_leaf = 2048;  // in points; most leaves have about 32

bool is_crowded(const KdTree& tree) noexcept {
    return std::any_of(tree.nodes().begin(), tree.nodes().end(), [](const KdNode& node) {
        return node.is_leaf() && node.reference_count() > crowded_leaf;
    });
}

KdBuild build_to_search(PointCloudView points) {
    KdOptions options = PointScene::search_options();
    KdBuild build = build_kd_tree(points, options);
    if (!is_crowded(build.tree)) return build;
    options.split.rule = "median";
    return build_kd_tree(points, options);
}

KdTree take_tree(KdBuild&& build, BuildReport& report) {
    report = std::move(build.report);
    return std::move(build.tree);
}

}  // namespace

KdOptions PointScene::search_options() {
    return {.sample = {.rate = 1.0 / 32.0},
            .split = {.rule = "midpoint",
                      .max_depth = KdTree::max_depth,
                      .max_leaf = 1,
                      .bad_refines = KdTree::max_depth + 1},  // splits whatever the cost
            .leaf_refinement = LeafRefinement::none};
}

PointScene::PointScene(std::vector<Vec3f> points)
    : points_(std::move(points)),
      search_(take_tree(build_to_search(PointCloudView(points_)), report_),
              PointCloudView(points_)) {}

PointScene::PointScene(std::vector<Vec3f> points, const KdOptions& options)
    : points_(std::move(points)),
      search_(take_tree(build_kd_tree(PointCloudView(points_), options), report_),
              PointCloudView(points_)) {}

}  // namespace coppice::inline v0
