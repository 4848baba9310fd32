#pragma once

#include "experiment/experiment_options.h"

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

}  // namespace coppice::lab
