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

AnyBuild build_tree(TriangleMeshView mesh, const BuildOptions& options,
                    const BuildControl& control) {
    if (const auto* const kd = std::get_if<KdOptions>(&options)) {
        auto [tree, report] = build_kd_tree(mesh, *kd, control);
        return {std::move(tree), std::move(report)};
    }
    auto [tree, report] = build_bvh8(mesh, std::get<Bvh8Options>(options), control);
    return {std::move(tree), std::move(report)};
}

std::unique_ptr<RayTracer> picture_tracer(TriangleMeshView mesh, int threads,
                                          const BuildControl& control) {
    Bvh8Options options = find_method("fast").bvh8_options();
    options.threads = threads;
    BuildControl unmeasured = control;
    unmeasured.is_measured = false;
    return make_tracer(build_bvh8(mesh, options, unmeasured).tree, mesh);
}

}  // namespace coppice::render
