// What a tree costs: the nodes that a camera ray visits, leaves included, and the primitives that
// it tests, before its closest hit is known.

#include "render/integrators/integrators.h"

namespace coppice::render {

namespace {

class CostIntegrator : public Integrator {
public:
    [[nodiscard]] Vec3d sample(const View& view, const Ray& ray, PixelSamples& /*random*/,
                               RayCounts& counts) const override {
        ++counts.primary;
        TraversalCounts steps;
        static_cast<void>(view.tracer->intersect(ray, steps));
        counts.steps += steps;
        const auto nodes = static_cast<double>(steps.nodes + steps.leaves);
        const auto primitives = static_cast<double>(steps.primitives);
        return {nodes, primitives, nodes + primitives};
    }
};

}  // namespace

std::unique_ptr<Integrator> make_cost(const IntegratorOptions& /*options*/) {
    return std::make_unique<CostIntegrator>();
}

}  // namespace coppice::render
