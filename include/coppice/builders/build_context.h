#pragma once

#include "coppice/base/memory_meter.h"
#include "coppice/builders/progress.h"

namespace coppice::inline v0 {

/// What the stages of a build tell while they work. An empty one costs nothing measurable.
///
/// A stop needs no member: run_with_threads() ends all work inside it.
struct BuildContext {
    MemoryMeter* memory = nullptr;  ///< counts the stages' arrays; null: nothing is counted
    Progress* progress = nullptr;   ///< is told what is done; null: nothing is told
};

}  // namespace coppice::inline v0
