#include "coppice/scene/scene.h"

#include "coppice/build/build_tree.h"
#include "coppice/trace/intersect.h"

#include <utility>

namespace coppice {

Scene::Scene(TriangleMesh mesh, const BuildOptions& options)
    : mesh_(std::move(mesh)), tree_(build_kd_tree(mesh_.view(), options, &report_)) {}

std::optional<Hit> Scene::intersect(const Ray& ray) const noexcept {
    return coppice::intersect(tree_, mesh_.view(), ray);
}

bool Scene::occluded(const Ray& ray) const noexcept {
    return coppice::occluded(tree_, mesh_.view(), ray);
}

}  // namespace coppice
