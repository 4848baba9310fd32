// Estimates a build by building a part of the scene with the same builder, so that nothing here
// depends on how a builder works. The part is a sixteenth of the scene, in pieces spread over all
// of it, and then a quarter of that part. Counts and bytes are extrapolated in proportion to the
// share. Seconds grow as n (a + b log2 n); the two sizes give b. Each part is built twice, and the
// faster build counts: the first build of a process is slower, and short ones are easily disturbed.
// The real build touches its memory for the first time, however; that cost is measured on an eighth
// of it.
//
// Cost: about a fifth of the build of a k-d tree, up to half of that of an 8-wide tree. Error: the
// difference between the pieces and the rest of the scene, and for the seconds the noise of the
// machine.

#include "coppice/builders/estimate.h"

#include "coppice/base/big_buffer.h"
#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"
#include "coppice/builders/build_tree.h"

#include "base/out_of_memory.h"
#include "builders/bvh8/plan.h"
#include "builders/probe.h"
#include "builders/require_usable.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace coppice::inline v0 {
namespace {

constexpr std::uint32_t most_pieces = 1024;
constexpr std::uint32_t piece_size = 1024;  // at least; smaller pieces are mostly border
constexpr std::uint32_t one_in = 16;        // share of the pieces that is probed
constexpr std::uint32_t thinned_to = 4;     // share of the probed pieces for the smaller probe

// Smaller scenes are probed as a whole: a part of them would be too small to extrapolate from.
constexpr std::uint32_t least_primitives = 16384;

struct ProbeBuild {
    double size;  // primitives of the scene that the probe stands for
    BuildReport report;

    [[nodiscard]] double seconds() const noexcept { return report.stages.wall_seconds(); }
};

// Seconds per primitive in a scene `scale` times as large as the larger probe.
double extrapolated_seconds(const ProbeBuild& smaller, const ProbeBuild& larger, double scale) {
    const double at_larger = larger.seconds() / larger.size;
    if (!(smaller.size > 0.0) || !(larger.size > smaller.size)) return at_larger;
    const double slope =
        (at_larger - smaller.seconds() / smaller.size) / std::log2(larger.size / smaller.size);
    // The slope is between 0 (time proportional to n) and that of n log n; anything else is noise.
    const double steepest = at_larger / std::log2(larger.size);
    return at_larger + std::clamp(slope, 0.0, steepest) * std::log2(scale);
}

// Seconds per byte to touch memory for the first time.
double touch_seconds(double byte_count) {
    constexpr std::size_t page_bytes = 4096;
    constexpr std::size_t most_bytes = std::size_t{64} << 20;
    const auto touched = std::clamp(static_cast<std::size_t>(byte_count), page_bytes, most_bytes);
    const BigBuffer memory(touched);
    const std::span<std::byte> bytes = memory.view<std::byte>(0, touched);
    const Timer timer;
    for (std::size_t at = 0; at < touched; at += page_bytes) {
        static_cast<volatile std::byte&>(bytes[at]) = std::byte{1};
    }
    return timer.seconds() / static_cast<double>(touched);
}

int thread_count(const BuildOptions& options) {
    const int available = hardware_thread_count();
    const int threads = threads_of(options);
    return threads > 0 ? std::min(threads, available) : available;
}

BuildEstimate extrapolated(const ProbeBuild& smaller, const ProbeBuild& larger, double scale) {
    const BuildReport& report = larger.report;
    const double peak_bytes = scale * static_cast<double>(report.peak_bytes);
    return {scale * static_cast<double>(report.statistics.reference_count),
            scale * static_cast<double>(report.tree_bytes), peak_bytes,
            scale * larger.size * extrapolated_seconds(smaller, larger, scale) +
                peak_bytes * touch_seconds(0.125 * peak_bytes) / thread_count(report.options)};
}

// The estimate from probes of a scene. `build(probe)` returns a ProbeBuild.
template <typename Options, typename Build>
BuildEstimate estimate_by(PrimitiveSetView primitives, const Options& options,
                          const std::stop_token& stop, Build&& build) {
    require_valid(options);
    return with_memory_errors("the estimate", [&] {
        const bool is_small = primitives.size() < least_primitives;
        const std::uint32_t pieces =
            is_small ? 1 : std::min(most_pieces, primitives.size() / piece_size);
        std::optional<Probe> probe;
        const auto take = [&] {
            require_usable(primitives);
            probe = take_probe(primitives, pieces, is_small ? 1 : one_in);
        };
        run_with_threads(options.threads, take, stop);
        const Probe thinned = probe->thinned(thinned_to);
        const auto faster_of_two = [&](const Probe& part) {
            const ProbeBuild first = build(part);
            const ProbeBuild second = build(part);
            return first.seconds() < second.seconds() ? first : second;
        };
        const ProbeBuild smaller = faster_of_two(thinned);
        const ProbeBuild larger = faster_of_two(*probe);
        return extrapolated(smaller, larger,
                            std::max(1.0, primitives.size() / std::max(1.0, larger.size)));
    });
}

}  // namespace

BuildEstimate estimate_kd_tree(PrimitiveSetView primitives, const KdOptions& options,
                               const std::stop_token& stop) {
    return estimate_by(primitives, options, stop, [&](const Probe& probe) {
        // Some of the cuts at the pieces' borders would be made by the tree anyway, others not.
        // Hence parts that exist because of such a cut count half.
        const std::uint64_t sum = probe.size() + probe.centers().size();
        return ProbeBuild{0.5 * static_cast<double>(sum),
                          build_kd_tree(probe, options, {.stop = stop}).report};
    });
}

BuildEstimate estimate_bvh8(TriangleMeshView mesh, const Bvh8Options& options,
                            const std::stop_token& stop) {
    return estimate_by(mesh, options, stop, [&](const Probe& probe) {
        // Uses whole triangles, since object splits do not cut them.
        std::vector<TriangleIndices> triangles;
        for (const ProbeCenter& center : probe.centers()) {
            triangles.push_back(mesh.triangles()[center.id]);
        }
        const auto size = static_cast<double>(triangles.size());
        const Bvh8Options probing = bvh8::scaled_down(options, mesh.size(), size / mesh.size());
        return ProbeBuild{size,
                          build_bvh8({mesh.vertices(), triangles}, probing, {.stop = stop}).report};
    });
}

}  // namespace coppice::inline v0
