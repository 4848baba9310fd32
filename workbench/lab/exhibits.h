#pragma once

#include "lab/experiment_options.h"
#include "lab/results.h"
#include "report/exhibits.h"

namespace coppice::lab {

/// What the report shows of a scene beside its numbers: a picture, heat maps of two trees of the
/// experiment, and both trees in boxes. Loads the scene and builds the two trees once more: that of
/// all primitives, and the smallest sample's among those recommended, or if that is all of them the
/// largest smaller one; over triangles if there are trees of them. Throws no Error: what cannot be
/// made is missing, and `missing` says why.
[[nodiscard]] report::SceneExhibits make_exhibits(const SceneResult& scene,
                                                  const ExperimentOptions& options);

}  // namespace coppice::lab
