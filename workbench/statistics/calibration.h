#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace coppice::lab {

/// What rays did on average, and what that took.
struct StepObservation {
    double nodes = 0.0;        ///< inner nodes a ray
    double primitives = 0.0;   ///< primitives tested a ray
    double nanoseconds = 0.0;  ///< a ray
};

/// The heuristic's constants as they are on a machine: nanoseconds = traversal * nodes +
/// intersection * primitives, as nearly as it can be with both >= 0.
struct Calibration {
    double traversal = 0.0;     ///< nanoseconds an inner node
    double intersection = 0.0;  ///< nanoseconds a primitive tested
    /// Their standard errors; nothing for one that is 0 or for fewer than three observations.
    std::optional<double> traversal_error;
    std::optional<double> intersection_error;
    double rms = 0.0;           ///< of the residuals, in nanoseconds
    double relative_rms = 0.0;  ///< of the residuals as shares of their times
    /// Share of the times' variance that is explained; nothing if they do not vary.
    std::optional<double> r_squared;
    std::size_t count = 0;  ///< of observations
    /// True if nodes and primitives go together in all observations, so that they cannot be told
    /// apart: then only one of the constants is given, and the other is 0.
    bool is_rank_deficient = false;
};

/// What the squares are of.
enum class Residual {
    absolute,  ///< nanoseconds: the slowest trees decide
    relative   ///< shares of the observed time: all trees do
};

/// The stable lower-case name, e.g. "absolute".
[[nodiscard]] constexpr std::string_view name_of(Residual residual) noexcept {
    return residual == Residual::absolute ? "absolute" : "relative";
}

/// Least squares. Nothing for fewer than two observations, or if none has any step. `rms` and
/// `r_squared` are of nanoseconds either way.
[[nodiscard]] std::optional<Calibration> calibrate(std::span<const StepObservation> observations,
                                                   Residual residual = Residual::absolute);

/// Why the constants that so many different trees gave should not be relied on, in a sentence;
/// empty if nothing speaks against it.
[[nodiscard]] std::string caution_of(const Calibration& found, Residual residual,
                                     std::size_t tree_count);

}  // namespace coppice::lab
