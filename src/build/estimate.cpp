// What a build will come to is found out by building a part of it: a sixteenth of the scene, in
// pieces from all over it, and a quarter of that again, by the very builder in question, so that
// nothing about any builder need be known here. Counts and bytes grow with the share probed.
// Seconds grow a little faster, as n (a + b log2 n): the two sizes give b. The smaller probe is
// built twice, since the first build of a process is slower than all others.
// Cost: about a tenth of the build. Error: what the pieces differ from the rest of the scene, and
// for the seconds the noise of the machine.

#include "coppice/build/estimate.h"

#include "coppice/base/parallel.h"
#include "coppice/build/build_tree.h"

#include "build/probe.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace coppice {
namespace {

constexpr std::uint32_t piece_count = 512;
constexpr std::uint32_t one_in = 16;     // of them is probed
constexpr std::uint32_t thinned_to = 4;  // one in so many of these

// A scene of fewer primitives is probed as a whole: it would leave too little to judge by.
constexpr std::uint32_t least_primitives = 16384;

struct ProbeBuild {
    double size;
    BuildReport report;

    [[nodiscard]] double seconds() const noexcept { return report.stages.wall_seconds(); }
};

// Seconds a primitive in a scene `scale` times the larger one, from those of two sizes.
double extrapolated_seconds(const ProbeBuild& smaller, const ProbeBuild& larger, double scale) {
    const double at_larger = larger.seconds() / larger.size;
    if (!(smaller.size > 0.0) || !(larger.size > smaller.size)) return at_larger;
    const double slope =
        (at_larger - smaller.seconds() / smaller.size) / std::log2(larger.size / smaller.size);
    // Between time by number alone and time by number and depth alone; the rest is noise.
    const double steepest = at_larger / std::log2(larger.size);
    return at_larger + std::clamp(slope, 0.0, steepest) * std::log2(scale);
}

Estimate extrapolated(const ProbeBuild& smaller, const ProbeBuild& larger, double scale) {
    const BuildReport& report = larger.report;
    return {scale * static_cast<double>(report.statistics.reference_count),
            scale * static_cast<double>(report.tree_bytes),
            scale * static_cast<double>(report.peak_bytes),
            scale * larger.size * extrapolated_seconds(smaller, larger, scale)};
}

// An estimate from probes of a scene, by `build(probe)`, which returns a ProbeBuild.
template <typename Build>
Estimate estimate_by(PrimitiveSetView primitives, const BuildOptions& options, Build&& build) {
    check(options);
    const bool is_small = primitives.size() < least_primitives;
    std::optional<Probe> probe;
    run_with_threads(options.threads, [&] {
        probe =
            is_small ? take_probe(primitives, 1, 1) : take_probe(primitives, piece_count, one_in);
    });
    const Probe thinned = probe->thinned(thinned_to);
    static_cast<void>(build(thinned));
    const ProbeBuild smaller = build(thinned);
    const ProbeBuild larger = build(*probe);
    const double share = static_cast<double>(std::max<std::uint64_t>(1, probe->centered_count()));
    return extrapolated(smaller, larger, std::max(1.0, primitives.size() / share));
}

}  // namespace

Estimate estimate_kd_tree(PrimitiveSetView primitives, const BuildOptions& options) {
    return estimate_by(primitives, options, [&](const Probe& probe) {
        ProbeBuild build{static_cast<double>(probe.size()), {}};
        static_cast<void>(build_kd_tree(probe, options, &build.report));
        return build;
    });
}

Estimate estimate_wide_bvh(TriangleMeshView mesh, const BuildOptions& options) {
    return estimate_by(mesh, options, [&](const Probe& probe) {
        // Whole triangles: object splits do not cut them.
        std::vector<TriangleIndices> triangles;
        for (const std::uint32_t id : probe.centered_ids())
            triangles.push_back(mesh.triangles()[id]);
        ProbeBuild build{static_cast<double>(triangles.size()), {}};
        static_cast<void>(build_wide_bvh({mesh.vertices(), triangles}, options, &build.report));
        return build;
    });
}

}  // namespace coppice
