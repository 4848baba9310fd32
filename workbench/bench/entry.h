#pragma once

#include "bench/bench_options.h"
#include "bench/bench_results.h"
#include "tracers/contestant.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace coppice::lab {

/// A contestant with all that was measured of it so far.
struct BenchEntry {
    BenchRow row;
    std::unique_ptr<Contestant> contestant;
    std::vector<double> wall_seconds;
    std::vector<double> cpu_seconds;
    std::array<std::vector<double>, 3> trace_seconds;
};

/// All contestants of a benchmark, for a scene and a number of threads: ours, then peers.
[[nodiscard]] std::vector<BenchEntry> make_entries(const BenchOptions& options,
                                                   const BenchScene& scene, int threads);

/// The order in which the contestants of a round run: ours and peers alternately, then what is left
/// over.
[[nodiscard]] std::vector<BenchEntry*> take_turns(std::vector<BenchEntry>& entries);

/// The row of a contestant that has run: the medians of its runs. `ray_counts` are by RayKind.
[[nodiscard]] BenchRow finished_row(const BenchEntry& entry, std::span<const RayKind> kinds,
                                    std::span<const std::uint64_t> ray_counts);

}  // namespace coppice::lab
