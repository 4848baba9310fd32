#include "experiment/tree_measurement.h"

#include "coppice/base/named.h"
#include "coppice/builders/build_tree.h"
#include "coppice/tree/walk.h"

#include "tracers/contestant.h"
#include "tracers/traced_tree.h"

#include <limits>
#include <utility>

namespace coppice::lab {

namespace {

void trace(AnyTree tree, const MeasuredScene& scene, TreeFigures& figures) {
    if (scene.rays == nullptr) return;
    figures.rays = scene.rays->measure(TracedTree(scene.mesh, std::move(tree)));
}

TreeFigures measure_kd(const KdOptions& options, const MeasuredScene& scene) {
    TreeFigures figures;
    auto [tree, report] = build_kd_tree(scene.primitives, options, scene.control);
    figures.report = std::move(report);
    const bool is_sampled =
        options.leaf_refinement == LeafRefinement::none && options.sample.rate < 1.0;
    if (is_sampled) figures.unsampled_tests = unsampled_tests(tree);
    trace(std::move(tree), scene, figures);
    return figures;
}

TreeFigures measure_bvh8(const Bvh8Options& options, const MeasuredScene& scene) {
    TreeFigures figures;
    auto [tree, report] = build_bvh8(scene.mesh, options, scene.control);
    figures.report = std::move(report);
    trace(std::move(tree), scene, figures);
    return figures;
}

TreeFigures measure_peer(const Builder& builder, const BuildOptions& options,
                         const MeasuredScene& scene) {
    const auto peer = find_named(peer_registry(), builder.name, "peer").make(threads_of(options));
    const BuildFigures built = peer->build(scene.mesh, true);
    TreeFigures figures;
    BuildReport& report = figures.report;
    report.options = options;
    report.primitive_count = scene.primitives.size();
    report.sample_count = report.primitive_count;
    report.stages.build.wall_seconds = built.wall_seconds;
    report.stages.build.cpu_seconds = built.cpu_seconds;
    report.tree_bytes = built.bytes;
    report.peak_bytes = built.peak_bytes;
    report.statistics.sah_cost = std::numeric_limits<double>::quiet_NaN();
    if (scene.rays != nullptr) figures.rays = scene.rays->measure(*peer);
    return figures;
}

}  // namespace

TreeFigures measure_tree(const Builder& builder, const BuildOptions& options,
                         const MeasuredScene& scene) {
    switch (builder.form) {
        case TreeForm::kd:
            return measure_kd(std::get<KdOptions>(options), scene);
        case TreeForm::bvh8:
            return measure_bvh8(std::get<Bvh8Options>(options), scene);
        case TreeForm::peer:
            break;
    }
    return measure_peer(builder, options, scene);
}

double unsampled_tests(const KdTree& tree) {
    const double root_area = tree.bounds().surface_area();
    if (!(root_area > 0.0)) return 0.0;
    double sum = 0.0;
    walk(tree, [&](const VisitedNode& at) {
        const KdNode& node = tree.nodes()[at.index];
        if (!node.is_leaf() || node.in_sample() == SampleContent::some) return;
        sum += at.box.surface_area() / root_area * node.reference_count();
    });
    return sum;
}

}  // namespace coppice::lab
