#include "coppice/build/empty_leaves.h"

#include <utility>

namespace coppice {

Skeleton empty_leaves(KdTree&& tree) {
    return Skeleton(std::move(tree));
}

}  // namespace coppice
