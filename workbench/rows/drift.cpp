#include "rows/drift.h"

#include "statistics/median.h"

#include <algorithm>
#include <map>
#include <vector>

namespace coppice::lab {

void remove_drift(std::span<ResultRow> rows) {
    std::map<RayKind, std::vector<double>> references;
    for (const ResultRow& row : rows) {
        for (const RayFigures& figures : row.rays) {
            references[figures.kind].push_back(figures.reference_seconds);
        }
    }
    std::map<RayKind, double> usual;
    for (const auto& [kind, seconds] : references) {
        usual[kind] = median_of(seconds);
    }
    for (ResultRow& row : rows) {
        double here = 0.0;
        double usually = 0.0;
        for (const RayFigures& figures : row.rays) {
            here += figures.reference_seconds;
            usually += usual[figures.kind];
        }
        for (RayFigures& figures : row.rays) {
            figures.drift = here / usually;
            figures.wall_seconds /= figures.drift;
        }
    }
}

std::pair<double, double> drift_range(std::span<const ResultRow> rows) {
    std::vector<double> drifts;
    for (const ResultRow& row : rows) {
        for (const RayFigures& figures : row.rays) {
            drifts.push_back(figures.drift);
        }
    }
    if (drifts.empty()) return {1.0, 1.0};
    const auto [least, most] = std::minmax_element(drifts.begin(), drifts.end());
    return {*least, *most};
}

}  // namespace coppice::lab
