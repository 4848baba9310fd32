#include "coppice/scene/point_scene.h"

#include "coppice/build/build_tree.h"

#include <utility>

namespace coppice {

BuildOptions PointScene::search_options() {
    return {.sample = {.rate = 1.0 / 32.0},
            .split = {.rule = "median",
                      .max_leaf = 1,
                      .bad_refines = 1'000,  // medians are taken at any price
                      .counting = Counting::sampled},
            .growth = Growth::none};
}

PointScene::PointScene(std::vector<Vec3f> points, const BuildOptions& options)
    : points_(std::move(points)),
      search_(build_kd_tree(PointCloudView(points_), options, &report_), PointCloudView(points_)) {}

}  // namespace coppice
