#pragma once

#include "experiment/experiment_options.h"
#include "rows/results.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace coppice::lab {

/// What an experiment is about to do.
struct ExperimentProgress {
    std::string scene;
    std::string step;           ///< e.g. "loading", "triangles, grown, 20 %, seed 1"
    std::size_t rows_done = 0;  ///< of this scene
    std::size_t row_count = 0;  ///< of this scene; 0 while it is being loaded
    /// An estimate from the rows measured so far and the size of the others; nothing at first.
    std::optional<double> remaining_seconds;
};

/// Callbacks of an experiment. Empty ones are not called.
struct ExperimentObserver {
    std::function<void(const ExperimentProgress&)> on_progress;
    std::function<void(const SceneResult&)> on_scene;  ///< when all rows of a scene are there
    std::function<void(const std::string&)> on_note;   ///< one line that the user should know
    /// When a tree is measured; also for the reference that is not listed.
    std::function<void(const TreeKey&, const TreeFigures&)> on_row;
    /// What was measured of a tree that need not be built again, as an earlier run has.
    std::function<std::optional<TreeFigures>(const TreeKey&)> find_finished;
    /// When all rows of a builder over a kind of primitive are there: the scene with the rows so
    /// far and what is recommended of them. What is found from all rows is not there yet.
    std::function<void(const SceneResult&)> on_builder;
};

/// Runs the experiment: for every scene, kind of primitive, builder, sampler, seed and rate it
/// builds the tree, measures it, traces rays if any are asked for, and frees it. The 100 % tree is
/// always built, first, because costs are relative to it; it is a row only if 100 is among the
/// rates. A builder that does not sample has only that one, and 8-wide trees and peers are of
/// triangles. Of the rates of an 8-wide tree that come to the same sample only the first is a row.
/// If there are several scenes all are loaded once before the first tree, so that a broken file
/// is found in time. Only one scene is in memory at a time.
/// Throws Error(invalid_argument) for options out of range, Error(unsupported) for a kind of
/// primitive that was asked for and that a scene has not, and like load_mesh().
[[nodiscard]] std::vector<SceneResult> run_experiment(const ExperimentOptions& options,
                                                      const ExperimentObserver& observer = {});

}  // namespace coppice::lab
