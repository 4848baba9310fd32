#include "coppice/builders/kd_options.h"

#include "coppice/base/parallel.h"
#include "coppice/builders/split_finder.h"
#include "coppice/tree/kd_tree.h"

#include "builders/require_in_range.h"

namespace coppice::inline v0 {

void require_valid(const KdOptions& options) {
    require_valid(options.sample);
    const SplitOptions& split = options.split;
    static_cast<void>(split_finder_of(split));
    require_in_range(split.max_depth >= 0 && split.max_depth <= KdTree::max_depth, "max depth",
                     split.max_depth, "[0, 60]");
    require_in_range(split.max_leaf >= 1, "max leaf", split.max_leaf, "[1, 2^32)");
    require_in_range(split.bad_refines >= 1, "bad refines", split.bad_refines, "[1, 2^31)");
    require_in_range(split.min_split >= 1, "min split", split.min_split, "[1, 2^32)");
    require_in_range(split.max_duplication >= 1, "max duplication", split.max_duplication,
                     "[1, 2^32)");
    require_thread_count(options.threads);
    require_valid(options.cost);
}

const char* name_of(Clipping clipping) noexcept {
    return clipping == Clipping::perfect ? "perfect" : "bounding_box";
}

const char* name_of(SampleWeighting sample_weighting) noexcept {
    return sample_weighting == SampleWeighting::sampled ? "sampled" : "expected";
}

const char* name_of(Termination termination) noexcept {
    return termination == Termination::limits ? "limits" : "sah";
}

const char* name_of(LeafRefinement leaf_refinement) noexcept {
    return leaf_refinement == LeafRefinement::none ? "none" : "kd";
}

}  // namespace coppice::inline v0
