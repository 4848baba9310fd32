#include "tracers/traced_tree.h"

#include "coppice/builders/build_tree.h"
#include "coppice/trace/intersect.h"

#include <utility>
#include <variant>

namespace coppice::lab {

namespace {

BuildControl unmeasured(BuildControl control) {
    control.is_measured = false;
    return control;
}

}  // namespace

TracedTree::TracedTree(TriangleMeshView mesh, const BuildOptions& options,
                       const BuildControl& control)
    : TracedTree(mesh, build_tree(mesh, options, unmeasured(control)).tree) {}

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

AnyBuild build_tree(TriangleMeshView mesh, const BuildOptions& options,
                    const BuildControl& control) {
    if (const auto* const kd = std::get_if<KdOptions>(&options)) {
        auto [tree, report] = build_kd_tree(mesh, *kd, control);
        return {std::move(tree), std::move(report)};
    }
    auto [tree, report] = build_bvh8(mesh, std::get<Bvh8Options>(options), control);
    return {std::move(tree), std::move(report)};
}

TracedTree build_picture_tree(TriangleMeshView mesh, int threads, const BuildControl& control) {
    Bvh8Options options = find_method("fast").bvh8_options();
    options.threads = threads;
    return {mesh, options, control};
}

}  // namespace coppice::lab
