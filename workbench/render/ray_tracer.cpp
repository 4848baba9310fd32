#include "render/ray_tracer.h"

#include "coppice/build/build_tree.h"
#include "coppice/trace/intersect.h"
#include "coppice/trace/wide_tracer.h"

#include <utility>

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

std::unique_ptr<RayTracer> build_tracer(const Method& method, const BuildOptions& options,
                                        TriangleMeshView mesh, BuildReport* report) {
    std::unique_ptr<RayTracer> tracer;
    if (method.tree == TreeKind::kd) {
        tracer = std::make_unique<KdRayTracer>(build_kd_tree(mesh, options, report), mesh);
    } else {
        tracer = std::make_unique<WideRayTracer>(build_wide_bvh(mesh, options, report));
    }
    if (report != nullptr) report->method = method.name;
    return tracer;
}

}  // namespace coppice::render
