#include "coppice/build/refine.h"

#include <utility>

namespace coppice {

KdTree refine(KdTree&& tree, PrimitiveSetView primitives, const BuildOptions& options,
              MemoryMeter* meter, Progress* progress) {
    switch (options.growth) {
        case Growth::none:
            return std::move(tree);
        case Growth::kd:
            return grow_kd(std::move(tree), primitives, options, meter, progress);
    }
    return std::move(tree);
}

}  // namespace coppice
