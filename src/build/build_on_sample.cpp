// Top-down construction of the k-d tree over the sample. At each node the split rule offers a
// plane; a node becomes a leaf when it has few enough primitives, at the depth limit, when no plane
// is offered, or after the allowed number of splits that do not pay. Events are sorted anew in
// every node: O(N log^2 N), simple, and what the thesis timed; see KdBuilder for the recursion.
// Source: [Tsiompikas2022] sec. 4.3.1, [Pharr2016] sec. 4.4.

#include "coppice/build/build_on_sample.h"

#include "build/kd_builder.h"
#include "build/partition.h"

#include <utility>

namespace coppice {

KdTree build_on_sample(PrimitiveSetView primitives, const Sample& sample,
                       const BuildOptions& options, MemoryMeter* meter) {
    const Aabb box = bounds_of_all(primitives);
    std::vector<Fragment> fragments;
    fragments.reserve(sample.ids.size());
    for (const std::uint32_t id : sample.ids)
        fragments.push_back({primitives.bounds(id), id});

    const StopRule stop{options.split.max_leaf, options.split.bad_refines, options.split.max_depth,
                        SplitSearch::first_offer};
    Subtree tree = KdBuilder(primitives, options, stop, meter).build(std::move(fragments), box, 0);
    return {std::move(tree.nodes), std::move(tree.references), box};
}

}  // namespace coppice
