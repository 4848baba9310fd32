#include "coppice/builders/empty_leaves.h"

#include <utility>

namespace coppice::inline v0 {

Skeleton empty_leaves(KdTree&& tree) {
    return Skeleton(std::move(tree));
}

}  // namespace coppice::inline v0
