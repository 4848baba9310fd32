// A sampler of one's own: every n-th primitive. The pipeline is functions in a row, so any sample
// can go into it.
#include <coppice/coppice.h>

#include <cstdio>
#include <utility>

namespace {

class EveryNth final : public coppice::Sampler {
public:
    [[nodiscard]] coppice::Sample draw(coppice::PrimitiveSetView primitives, std::uint32_t count,
                                       const coppice::SampleOptions& options) const override {
        coppice::Sample sample{.ids = {}, .weights = {}, .options = options};
        for (std::uint64_t i = 0; i < count; ++i) {
            sample.ids.push_back(static_cast<std::uint32_t>(i * primitives.size() / count));
        }
        return sample;
    }
};

double cost_with(const coppice::Sample& sample, coppice::PrimitiveSetView primitives,
                 const coppice::BuildOptions& options) {
    coppice::KdTree sampled = coppice::build_on_sample(primitives, sample, options);
    coppice::Skeleton skeleton = coppice::empty_leaves(std::move(sampled));
    coppice::KdTree refilled = coppice::refill(std::move(skeleton), primitives, options);
    const coppice::KdTree tree = coppice::refine(std::move(refilled), primitives, options);
    return coppice::measure(tree, options.cost).sah_cost;
}

}  // namespace

int main() {
    const coppice::TriangleMesh mesh = coppice::load_mesh("bunny.obj");
    const coppice::TriangleMeshView triangles = mesh.view();
    const coppice::BuildOptions options{.sample = {.rate = 0.1},
                                        .split = {.max_leaf = 3},
                                        .leaf_refinement = coppice::LeafRefinement::none};
    const std::uint32_t count = coppice::sample_count(triangles.size(), options.sample.rate);

    const EveryNth every_nth;
    const coppice::Sampler& uniform = coppice::find_sampler("uniform");
    for (const auto& [name, sampler] :
         {std::pair<const char*, const coppice::Sampler*>{"every n-th", &every_nth},
          {"uniform", &uniform}}) {
        const coppice::Sample sample = sampler->draw(triangles, count, options.sample);
        std::printf("%s: cost %.2f\n", name, cost_with(sample, triangles, options));
    }
}
