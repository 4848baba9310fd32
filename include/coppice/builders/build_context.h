#pragma once

#include "coppice/base/memory_meter.h"
#include "coppice/builders/progress.h"

namespace coppice::inline v0 {

/// Receives what the stages of a build report while they run. An empty context costs nothing
/// measurable.
///
/// Cancellation needs no member here: run_with_threads() ends all work inside it.
struct BuildContext {
    MemoryMeter* memory = nullptr;  ///< counts the stages' arrays; null disables it
    Progress* progress = nullptr;   ///< receives the progress; null disables it
};

}  // namespace coppice::inline v0
