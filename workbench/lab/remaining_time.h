#pragma once

#include "lab/experiment_options.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace coppice::lab {

/// What the work of a build depends on.
struct BuildWork {
    PrimitiveKind kind = PrimitiveKind::points;
    std::string_view protocol;
    double percent = 100.0;
    double primitive_count = 0.0;
};

/// The expected work of a build in an arbitrary unit: the sampled primitives are sorted and split,
/// all are refilled, and `grown` trees go on with all of them. The weights are those of a scanned
/// mesh of a million triangles; where a scene differs, the rows measured so far make up for it.
[[nodiscard]] inline double work_of_build(const BuildWork& build) {
    constexpr double split = 1.0;
    constexpr double refill = 0.13;
    constexpr double refine = 0.9;
    // A triangle costs more than a point: it is clipped, and it is in several leaves.
    const double of_kind = build.kind == PrimitiveKind::triangles ? 1.6 : 1.0;
    const double of_sample = split * build.percent / 100.0;
    const double of_all = refill + (build.protocol == "grown" ? refine : 0.0);
    return build.primitive_count * of_kind * (of_sample + of_all);
}

/// How long planned work will still take, judged by the work done so far.
class RemainingTime {
public:
    /// Adds work to be done.
    void plan(double work) noexcept { planned_ += work; }

    /// Records that some of the planned work took `seconds`.
    void finish(double work, double seconds) noexcept {
        done_ += work;
        seconds_ += seconds;
    }

    /// Seconds of the work that is left; nothing while none is done.
    [[nodiscard]] std::optional<double> seconds() const noexcept {
        if (!(done_ > 0.0)) return std::nullopt;
        return seconds_ / done_ * std::max(0.0, planned_ - done_);
    }

private:
    double planned_ = 0.0;
    double done_ = 0.0;
    double seconds_ = 0.0;
};

}  // namespace coppice::lab
