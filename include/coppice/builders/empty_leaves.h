#pragma once

#include "coppice/export.h"
#include "coppice/tree/kd_tree.h"

namespace coppice::inline v0 {

/// Third stage: drops all references and keeps all planes.
/// Source: [Tsiompikas2022] sec. 4.3.2.
[[nodiscard]] COPPICE_EXPORT Skeleton empty_leaves(KdTree&& tree);

}  // namespace coppice::inline v0
