#pragma once

#include "coppice/build/build_options.h"
#include "coppice/cost/tree_statistics.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>

namespace coppice {

/// Wall-clock seconds of each stage of a build.
struct StageSeconds {
    double sample = 0.0;
    double build = 0.0;
    double empty = 0.0;
    double refill = 0.0;
    double refine = 0.0;

    [[nodiscard]] constexpr double total() const noexcept {
        return sample + build + empty + refill + refine;
    }
};

/// What a build did: its options, sizes, times, and the measured tree.
struct BuildReport {
    BuildOptions options;
    std::uint32_t primitive_count = 0;
    std::uint32_t sample_count = 0;
    StageSeconds seconds;
    TreeStatistics statistics;
};

/// Serializes all fields under their own names.
void to_json(nlohmann::json& json, const BuildReport& report);

}  // namespace coppice
