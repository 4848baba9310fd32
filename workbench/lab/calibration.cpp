// Least squares in two unknowns that must not be negative: if the free optimum has a negative one,
// the best is on the border, where one of them is 0. Times of trees spread over orders of
// magnitude: hence the choice of residuals. Source: [LawsonHanson1974] ch. 23.

#include "lab/calibration.h"

#include <algorithm>
#include <cmath>

namespace coppice::lab {

namespace {

/// Below this share of what it could be the determinant is rounding, or chance: the columns' sine.
constexpr double least_sine = 1e-3;

/// The sums of the normal equations.
struct Sums {
    double nn = 0.0;
    double np = 0.0;
    double pp = 0.0;
    double nt = 0.0;
    double pt = 0.0;
};

Sums sums_of(std::span<const StepObservation> observations, Residual residual) {
    Sums sums;
    for (const StepObservation& of : observations) {
        const bool is_weighted = residual == Residual::relative && of.nanoseconds > 0.0;
        const double weight = is_weighted ? 1.0 / (of.nanoseconds * of.nanoseconds) : 1.0;
        sums.nn += weight * of.nodes * of.nodes;
        sums.np += weight * of.nodes * of.primitives;
        sums.pp += weight * of.primitives * of.primitives;
        sums.nt += weight * of.nodes * of.nanoseconds;
        sums.pt += weight * of.primitives * of.nanoseconds;
    }
    return sums;
}

/// The better one of the two solutions on the border.
void solve_border(const Sums& sums, Calibration& found) {
    const double by_nodes = sums.nn > 0.0 ? sums.nt * sums.nt / sums.nn : 0.0;
    const double by_primitives = sums.pp > 0.0 ? sums.pt * sums.pt / sums.pp : 0.0;
    found.traversal = by_nodes >= by_primitives ? sums.nt / sums.nn : 0.0;
    found.intersection = by_nodes >= by_primitives ? 0.0 : sums.pt / sums.pp;
}

void find_residuals(std::span<const StepObservation> observations, Calibration& found) {
    double mean = 0.0;
    for (const StepObservation& of : observations) {
        mean += of.nanoseconds / static_cast<double>(observations.size());
    }
    double left = 0.0;
    double relative = 0.0;
    double all = 0.0;
    for (const StepObservation& of : observations) {
        const double off =
            of.nanoseconds - found.traversal * of.nodes - found.intersection * of.primitives;
        left += off * off;
        if (of.nanoseconds > 0.0) relative += off * off / (of.nanoseconds * of.nanoseconds);
        all += (of.nanoseconds - mean) * (of.nanoseconds - mean);
    }
    found.rms = std::sqrt(left / static_cast<double>(observations.size()));
    found.relative_rms = std::sqrt(relative / static_cast<double>(observations.size()));
    if (all > 0.0) found.r_squared = 1.0 - left / all;
}

}  // namespace

std::optional<Calibration> calibrate(std::span<const StepObservation> observations,
                                     Residual residual) {
    const Sums sums = sums_of(observations, residual);
    if (observations.size() < 2 || !(sums.nn + sums.pp > 0.0)) return std::nullopt;
    Calibration found;
    found.count = observations.size();
    const double determinant = sums.nn * sums.pp - sums.np * sums.np;
    found.is_rank_deficient = determinant <= least_sine * least_sine * sums.nn * sums.pp;
    found.traversal = (sums.pp * sums.nt - sums.np * sums.pt) / determinant;
    found.intersection = (sums.nn * sums.pt - sums.np * sums.nt) / determinant;
    const bool is_inside = found.traversal >= 0.0 && found.intersection >= 0.0;
    if (found.is_rank_deficient || !is_inside) solve_border(sums, found);
    find_residuals(observations, found);
    return found;
}

}  // namespace coppice::lab
