#pragma once

#include "experiment/experiment_options.h"
#include "report/exhibits.h"
#include "rows/results.h"

#include <cstddef>

namespace coppice::lab {

/// Scenes of one page whose trees are shown.
inline constexpr std::size_t most_inspected = 8;

/// What the report shows of a scene beside its numbers: a picture, heat maps of two trees of the
/// experiment, and both trees in boxes. Loads the scene and builds the two trees once more: that of
/// all primitives, and the smallest sample's among those recommended, or if that is all of them the
/// largest smaller one; over triangles if there are trees of them. Throws no Error: what cannot be
/// made is missing, and `missing` says why. A page of several scenes must stay readable: they share
/// what inspectors take of it, and only the first most_inspected have one, and heat maps.
/// @param place  of the scene among those of the options, from 0
[[nodiscard]] report::SceneExhibits make_exhibits(const SceneResult& scene,
                                                  const ExperimentOptions& options,
                                                  std::size_t place = 0);

}  // namespace coppice::lab
