#include "render/ray_tracer.h"

#include "coppice/build/build_tree.h"
#include "coppice/trace/intersect.h"
#include "coppice/trace/wide_tracer.h"

#include <utility>
#include <variant>

namespace coppice::render {

namespace {

class WideRayTracer : public RayTracer {
public:
    explicit WideRayTracer(WideBvh tree) : tracer_(std::move(tree)) {}

    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const noexcept override {
        return tracer_.intersect(ray);
    }

    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray,
                                               TraversalCounts& counts) const noexcept override {
        return tracer_.intersect(ray, counts);
    }

    [[nodiscard]] bool occluded(const Ray& ray) const noexcept override {
        return tracer_.occluded(ray);
    }

private:
    WideTracer tracer_;
};

class KdRayTracer : public RayTracer {
public:
    KdRayTracer(KdTree tree, TriangleMeshView mesh) : tree_(std::move(tree)), mesh_(mesh) {}

    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const noexcept override {
        return coppice::intersect(tree_, mesh_, ray);
    }

    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray,
                                               TraversalCounts& counts) const noexcept override {
        return coppice::intersect(tree_, mesh_, ray, counts);
    }

    [[nodiscard]] bool occluded(const Ray& ray) const noexcept override {
        return coppice::occluded(tree_, mesh_, ray);
    }

private:
    KdTree tree_;
    TriangleMeshView mesh_;
};

}  // namespace

std::unique_ptr<RayTracer> make_tracer(AnyTree tree, TriangleMeshView mesh) {
    if (auto* const wide = std::get_if<WideBvh>(&tree)) {
        return std::make_unique<WideRayTracer>(std::move(*wide));
    }
    return std::make_unique<KdRayTracer>(std::get<KdTree>(std::move(tree)), mesh);
}

std::unique_ptr<RayTracer> build_tracer(const Method& method, const BuildOptions& options,
                                        TriangleMeshView mesh, BuildReport* report,
                                        const BuildControl& control) {
    AnyTree tree;
    if (method.tree == TreeKind::kd) {
        tree = build_kd_tree(mesh, options, report, control);
    } else {
        tree = build_wide_bvh(mesh, options, report, control);
    }
    if (report != nullptr) report->method = method.name;
    return make_tracer(std::move(tree), mesh);
}

}  // namespace coppice::render
