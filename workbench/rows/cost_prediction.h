#pragma once

#include "rows/results.h"
#include "statistics/calibration.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coppice::lab {

/// How well the cost of trees of one form predicts what rays take, for one kind of rays or all.
struct CostPrediction {
    TreeForm form = TreeForm::kd;
    std::string rays;            ///< the kind's name, or "all"
    std::size_t tree_count = 0;  ///< one for each row
    /// Rank correlations of the cost with the wall-clock time of a ray, and with the counted steps
    /// of a ray in the cost model's own unit: t_trav times nodes and t_isect times primitives.
    std::optional<double> with_time;
    std::optional<double> with_steps;
};

/// The heuristic's constants found from the trees of one form.
struct FormCalibration {
    TreeForm form = TreeForm::kd;
    Residual residual = Residual::absolute;
    Calibration found;
    std::size_t tree_count = 0;  ///< different ones, by their cost
    std::string caution;         ///< why not to rely on it, in a sentence; or empty
};

/// For each form of tree among the traced rows of a scene, but peers: all rays together, then kind
/// by kind.
[[nodiscard]] std::vector<CostPrediction> find_predictions(std::span<const ResultRow> rows);

/// For each form of tree among the traced rows of a scene, but peers, by both residuals: an
/// observation is a tree with a kind of rays, its time the wall clock's on all threads of the run.
[[nodiscard]] std::vector<FormCalibration> find_calibrations(std::span<const ResultRow> rows);

}  // namespace coppice::lab
