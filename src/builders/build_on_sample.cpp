// Top-down construction of the k-d tree over the sample. At each node the split rule proposes a
// plane. A node becomes a leaf if it has few enough primitives, at the depth limit, if the rule
// finds no plane, or after the allowed number of splits that do not pay. The rule `sah` sorts
// events anew in every node: O(N log^2 N), simple, and what the thesis measured. KdBuilder has the
// recursion. For rules that find the cheapest end, ExactBuilder gives the same tree sooner.
// Source: [Tsiompikas2022] sec. 4.3.1, [Pharr2016] sec. 4.4.

#include "coppice/builders/build_on_sample.h"

#include "coppice/base/parallel.h"

#include "builders/chunk_sizes.h"
#include "builders/kd/exact/exact_builder.h"
#include "builders/kd/kd_builder.h"
#include "builders/kd/partition.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coppice::inline v0 {
namespace {

// Weights are rounded to multiples of 1/256. Their sums are exact in double, so that they do not
// depend on the order of PrimRefs, and the weight of an empty side is exactly 0.
float rounded_weight(double weight) {
    return static_cast<float>(std::max(256.0, std::round(256.0 * weight)) / 256.0);
}

// The weight of the sampled primitive at an index.
float weight_at(const Sample& sample, std::size_t index, SampleWeighting sample_weighting) {
    if (sample_weighting == SampleWeighting::sampled) return 1.0F;
    return rounded_weight(sample.weights.empty() ? 1.0 / sample.options.rate
                                                 : sample.weights[index]);
}

TerminationRule termination_rule(const SplitOptions& split) {
    if (split.termination == Termination::sah) return until_it_pays(split);
    return {split.max_leaf, split.bad_refines, split.max_depth, SplitSearch::first_offer, 0.0};
}

TreePart build_part(PrimitiveSetView primitives, const KdOptions& options,
                    std::vector<PrimRef> prim_refs, const Aabb& box, const BuildContext& context) {
    const TerminationRule stop = termination_rule(options.split);
    const NodeState root{.box = box};
    const WorkShare work(context.progress);
    if (split_finder_of(options.split).finds_cheapest_end()) {
        return ExactBuilder(primitives, options, stop, context.memory)
            .build(std::move(prim_refs), root, work);
    }
    return KdBuilder(primitives, options, stop, context.memory)
        .build(std::move(prim_refs), root, work);
}

}  // namespace

KdTree build_on_sample(PrimitiveSetView primitives, const Sample& sample, const KdOptions& options,
                       const BuildContext& context) {
    const Aabb box = bounds_of_all(primitives);
    std::vector<PrimRef> prim_refs(sample.ids.size());
    parallel_for_chunks(
        prim_refs.size(), primitives_per_task, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::uint32_t id = sample.ids[i];
                prim_refs[i] = {primitives.bounds(id), id,
                                weight_at(sample, i, options.split.sample_weighting)};
            }
        });
    Subtree tree = assemble(build_part(primitives, options, std::move(prim_refs), box, context),
                            context.memory);
    return {std::move(tree.nodes), std::move(tree.references), box};
}

}  // namespace coppice::inline v0
