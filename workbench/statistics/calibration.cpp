// Least squares in two unknowns that must not be negative: if the free optimum has a negative one,
// the best is on the border, where one of them is 0. Times of trees spread over orders of
// magnitude: hence the choice of residuals. Source: [LawsonHanson1974] ch. 23.

#include "statistics/calibration.h"

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

/// By the variance of the residuals, weighed as in the sums; of a solution on the border that of
/// the one constant which is not 0.
void find_errors(std::span<const StepObservation> observations, const Sums& sums, Residual residual,
                 Calibration& found) {
    const bool has_both = found.traversal > 0.0 && found.intersection > 0.0;
    const std::size_t unknowns = has_both ? 2 : 1;
    if (observations.size() < 3) return;
    double squares = 0.0;
    for (const StepObservation& of : observations) {
        const double off =
            of.nanoseconds - found.traversal * of.nodes - found.intersection * of.primitives;
        const bool is_weighted = residual == Residual::relative && of.nanoseconds > 0.0;
        squares += off * off / (is_weighted ? of.nanoseconds * of.nanoseconds : 1.0);
    }
    const double variance = squares / static_cast<double>(observations.size() - unknowns);
    const double determinant = sums.nn * sums.pp - sums.np * sums.np;
    if (found.traversal > 0.0) {
        found.traversal_error =
            std::sqrt(variance * (has_both ? sums.pp / determinant : 1.0 / sums.nn));
    }
    if (found.intersection > 0.0) {
        found.intersection_error =
            std::sqrt(variance * (has_both ? sums.nn / determinant : 1.0 / sums.pp));
    }
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
    find_errors(observations, sums, residual, found);
    find_residuals(observations, found);
    return found;
}

std::string caution_of(const Calibration& found, Residual residual, std::size_t tree_count) {
    constexpr double most_uncertain = 0.5;
    constexpr std::size_t enough_trees = 4;
    if (found.is_rank_deficient) {
        return "rank-deficient: nodes and tests go together in all of them and cannot be told "
               "apart";
    }
    if (tree_count < enough_trees) {
        return "not to be used: of too few different trees; more --methods and --rates make more";
    }
    const bool is_vague = residual == Residual::absolute
                              ? found.r_squared.value_or(0.0) < most_uncertain
                              : found.relative_rms > most_uncertain;
    if (is_vague) {
        return "not to be used: the two explain the times badly; more methods and rates, more "
               "rays (--size) or a quieter machine help";
    }
    if (found.traversal == 0.0 || found.intersection == 0.0) {
        return "one of the two is 0, the least it may be: these trees differ too little to tell "
               "nodes and tests apart";
    }
    if (found.traversal_error.value_or(0.0) > most_uncertain * found.traversal ||
        found.intersection_error.value_or(0.0) > most_uncertain * found.intersection) {
        return "one of the two is uncertain by more than half of itself";
    }
    return {};
}

}  // namespace coppice::lab
