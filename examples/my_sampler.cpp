// A sampler of one's own: every n-th primitive. Options take it in place of the name of one of
// ours.
#include <coppice/coppice.h>

#include <cstdio>
#include <memory>

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

}  // namespace

int main() {
    const coppice::TriangleMesh mesh = coppice::load_mesh("bunny.obj");
    coppice::KdOptions options{.sample = {.rate = 0.1},
                               .split = {.max_leaf = 3},
                               .leaf_refinement = coppice::LeafRefinement::none};
    const auto uniform = coppice::build_kd_tree(mesh.view(), options);
    options.sample.custom_sampler = std::make_shared<const EveryNth>();
    const auto every_nth = coppice::build_kd_tree(mesh.view(), options);

    std::printf("every n-th: cost %.2f\n", every_nth.report.statistics.sah_cost);
    std::printf("uniform: cost %.2f\n", uniform.report.statistics.sah_cost);
}
