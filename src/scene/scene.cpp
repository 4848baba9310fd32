#include "coppice/scene/scene.h"

#include "coppice/build/build_tree.h"

#include <utility>

namespace coppice {

Scene::Scene(TriangleMesh mesh, const BuildOptions& options, const BuildControl& control)
    : mesh_(std::move(mesh)),
      tracer_(build_wide_bvh(mesh_.view(), options, &report_, control)),
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

}  // namespace coppice
