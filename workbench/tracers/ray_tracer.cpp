#include "tracers/ray_tracer.h"

#include "coppice/builders/build_tree.h"
#include "coppice/trace/bvh8_tracer.h"
#include "coppice/trace/intersect.h"

#include <utility>
#include <variant>

namespace coppice::render {

namespace {

class Bvh8RayTracer : public RayTracer {
public:
    explicit Bvh8RayTracer(Bvh8 tree) : tracer_(std::move(tree)) {}

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
    Bvh8Tracer tracer_;
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
    if (auto* const wide = std::get_if<Bvh8>(&tree)) {
        return std::make_unique<Bvh8RayTracer>(std::move(*wide));
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
        tree = build_bvh8(mesh, options, report, control);
    }
    if (report != nullptr) report->method = method.name;
    return make_tracer(std::move(tree), mesh);
}

std::unique_ptr<RayTracer> picture_tracer(TriangleMeshView mesh, int threads,
                                          const BuildControl& control) {
    const Method& method = find_method("fast");
    BuildOptions build = method.options();
    build.threads = threads;
    return build_tracer(method, build, mesh, nullptr, control);
}

}  // namespace coppice::render
