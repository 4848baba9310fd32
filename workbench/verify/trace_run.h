#pragma once

#include "verify/trace_options.h"
#include "verify/trace_results.h"

#include <functional>
#include <string>
#include <vector>

namespace coppice::lab {

/// Callbacks of a run. Empty ones are not called.
struct TraceObserver {
    std::function<void(const std::string& step)> on_progress;
    std::function<void(const TraceScene& scene)> on_scene;
};

/// Builds a tree for each scene, traces all kinds of rays against it once, and compares the hits
/// with a reference's if that is asked for: each ray that they do not agree on goes to the exact
/// judge. Throws Error(invalid_argument) for options out of range or a reference that this program
/// was built without, Error(unsupported) for a scene without triangles, and like load_mesh().
[[nodiscard]] std::vector<TraceScene> run_trace(const TraceOptions& options,
                                                const TraceObserver& observer = {});

}  // namespace coppice::lab
