#include "coppice/builders/refine.h"

#include <utility>

namespace coppice::inline v0 {

KdTree refine(KdTree&& tree, PrimitiveSetView primitives, const BuildOptions& options,
              MemoryMeter* meter, Progress* progress) {
    switch (options.leaf_refinement) {
        case LeafRefinement::none:
            return std::move(tree);
        case LeafRefinement::kd:
            return grow_kd(std::move(tree), primitives, options, meter, progress);
    }
    return std::move(tree);
}

}  // namespace coppice::inline v0
