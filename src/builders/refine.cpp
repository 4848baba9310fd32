#include "coppice/builders/refine.h"

#include <utility>

namespace coppice::inline v0 {

KdTree refine(KdTree&& tree, PrimitiveSetView primitives, const KdOptions& options,
              const BuildContext& context) {
    switch (options.leaf_refinement) {
        case LeafRefinement::none:
            return std::move(tree);
        case LeafRefinement::kd:
            return grow_kd(std::move(tree), primitives, options, context);
    }
    return std::move(tree);
}

}  // namespace coppice::inline v0
