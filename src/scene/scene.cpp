#include "coppice/scene/scene.h"

#include "coppice/builders/build_tree.h"

#include <utility>

namespace coppice::inline v0 {
namespace {

Bvh8 take_tree(Bvh8Build&& build, BuildReport& report) {
    report = std::move(build.report);
    return std::move(build.tree);
}

}  // namespace

Scene::Scene(TriangleMesh mesh, const Bvh8Options& options, const BuildControl& control)
    : mesh_(std::move(mesh)),
      tracer_(take_tree(build_bvh8(mesh_.view(), options, control), report_)),
      search_(tracer_.tree()) {}

std::optional<Hit> Scene::intersect(const Ray& ray) const noexcept {
    return tracer_.intersect(ray);
}

bool Scene::occluded(const Ray& ray) const noexcept {
    return tracer_.occluded(ray);
}

SignedDistance Scene::make_signed_distance() const {
    return {mesh_.view(), search_};
}

}  // namespace coppice::inline v0
