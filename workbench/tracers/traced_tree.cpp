#include "tracers/traced_tree.h"

#include "coppice/builders/build_tree.h"
#include "coppice/trace/intersect.h"

#include <utility>
#include <variant>

namespace coppice::lab {

TracedTree::TracedTree(TriangleMeshView mesh, TreeKind kind, const BuildOptions& options,
                       const BuildControl& control)
    : mesh_(mesh) {
    if (kind == TreeKind::bvh8) {
        bvh8_.emplace(build_bvh8(mesh, options, nullptr, control));
    } else {
        kd_ = build_kd_tree(mesh, options, nullptr, control);
    }
}

TracedTree::TracedTree(TriangleMeshView mesh, AnyTree tree) : mesh_(mesh) {
    if (auto* const wide = std::get_if<Bvh8>(&tree)) {
        bvh8_.emplace(std::move(*wide));
    } else {
        kd_ = std::get<KdTree>(std::move(tree));
    }
}

std::optional<Hit> TracedTree::intersect(const Ray& ray) const noexcept {
    return bvh8_ ? bvh8_->intersect(ray) : coppice::intersect(kd_, mesh_, ray);
}

std::optional<Hit> TracedTree::intersect(const Ray& ray, TraversalCounts& counts) const noexcept {
    return bvh8_ ? bvh8_->intersect(ray, counts) : coppice::intersect(kd_, mesh_, ray, counts);
}

bool TracedTree::occluded(const Ray& ray) const noexcept {
    return bvh8_ ? bvh8_->occluded(ray) : coppice::occluded(kd_, mesh_, ray);
}

bool TracedTree::occluded(const Ray& ray, TraversalCounts& counts) const noexcept {
    return bvh8_ ? bvh8_->occluded(ray, counts) : coppice::occluded(kd_, mesh_, ray, counts);
}

}  // namespace coppice::lab
