#include "rows/cost_prediction.h"

#include "statistics/rank_correlation.h"

#include <array>
#include <set>

namespace coppice::lab {

namespace {

constexpr std::array measured_forms{TreeForm::kd, TreeForm::bvh8};

std::vector<const ResultRow*> traced_rows(std::span<const ResultRow> rows, TreeForm form) {
    std::vector<const ResultRow*> traced;
    for (const ResultRow& row : rows) {
        if (row.form == form && !row.rays.empty()) traced.push_back(&row);
    }
    return traced;
}

/// Steps of all these rays in the unit of the row's cost, and their nanoseconds.
struct Sums {
    double rays = 0.0;
    double steps = 0.0;
    double nanoseconds = 0.0;

    void add(const SahCostModel& cost, const RayFigures& figures) {
        const auto count = static_cast<double>(figures.rays);
        const MeanSteps mean = figures.steps.value_or(MeanSteps{});
        rays += count;
        steps += count * (cost.traversal * mean.nodes + cost.intersection * mean.primitives);
        nanoseconds += count * figures.nanoseconds();
    }
};

/// `kind` null: of all kinds.
CostPrediction prediction_of(const std::vector<const ResultRow*>& rows, const RayKind* kind) {
    CostPrediction prediction{
        rows.front()->form, kind != nullptr ? std::string(name_of(*kind)) : "all", 0, {}, {}};
    std::vector<double> costs;
    std::vector<double> times;
    std::vector<double> steps;
    for (const ResultRow* row : rows) {
        Sums sums;
        for (const RayFigures& figures : row->rays) {
            const bool is_asked = kind == nullptr || figures.kind == *kind;
            if (is_asked) sums.add(cost_of(row->report.options), figures);
        }
        if (!(sums.rays > 0.0)) continue;
        costs.push_back(row->report.statistics.sah_cost);
        times.push_back(sums.nanoseconds / sums.rays);
        steps.push_back(sums.steps / sums.rays);
    }
    prediction.tree_count = costs.size();
    prediction.with_time = rank_correlation(costs, times);
    prediction.with_steps = rank_correlation(costs, steps);
    return prediction;
}

}  // namespace

std::vector<CostPrediction> find_predictions(std::span<const ResultRow> rows) {
    std::vector<CostPrediction> predictions;
    for (const TreeForm form : measured_forms) {
        const std::vector<const ResultRow*> traced = traced_rows(rows, form);
        if (traced.empty()) continue;
        predictions.push_back(prediction_of(traced, nullptr));
        for (const RayFigures& figures : traced.front()->rays) {
            predictions.push_back(prediction_of(traced, &figures.kind));
        }
    }
    return predictions;
}

std::vector<FormCalibration> find_calibrations(std::span<const ResultRow> rows) {
    std::vector<FormCalibration> calibrations;
    for (const TreeForm form : measured_forms) {
        std::vector<StepObservation> observations;
        std::set<double> costs;
        for (const ResultRow* row : traced_rows(rows, form)) {
            costs.insert(row->report.statistics.sah_cost);
            for (const RayFigures& figures : row->rays) {
                if (!figures.steps) continue;
                observations.push_back(
                    {figures.steps->nodes, figures.steps->primitives, figures.nanoseconds()});
            }
        }
        for (const Residual residual : {Residual::absolute, Residual::relative}) {
            const auto found = calibrate(observations, residual);
            if (!found) continue;
            calibrations.push_back(
                {form, residual, *found, costs.size(), caution_of(*found, residual, costs.size())});
        }
    }
    return calibrations;
}

}  // namespace coppice::lab
