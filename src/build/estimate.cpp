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
#include <limits>
#include <vector>

namespace coppice {
namespace {

constexpr std::uint32_t one_in = 16;     // pieces of the scene
constexpr std::uint32_t thinned_to = 4;  // one in so many of these

// A scene of fewer primitives is probed as a whole: it would leave too little to judge by.
constexpr std::uint32_t least_primitives = 16384;

// A wide tree's probe is made of so many stretches of the mesh.
constexpr std::uint32_t stretch_count = 16;

struct ProbeBuild {
    double size;
    double seconds;
    BuildReport report;
};

ProbeBuild build_probe(const Probe& probe, const BuildOptions& options) {
    ProbeBuild build{static_cast<double>(probe.size()), 0.0, {}};
    static_cast<void>(build_kd_tree(probe, options, &build.report));
    build.seconds = build.report.stages.wall_seconds();
    return build;
}

// Seconds a primitive in a scene `scale` times the larger one, from those of two sizes.
double extrapolated_seconds(const ProbeBuild& smaller, const ProbeBuild& larger, double scale) {
    const double at_larger = larger.seconds / larger.size;
    if (!(smaller.size > 0.0) || !(larger.size > smaller.size)) return at_larger;
    const double slope =
        (at_larger - smaller.seconds / smaller.size) / std::log2(larger.size / smaller.size);
    // Between time by number alone and time by number and depth alone; the rest is noise.
    const double steepest = at_larger / std::log2(larger.size);
    return at_larger + std::clamp(slope, 0.0, steepest) * std::log2(scale);
}

}  // namespace

Estimate estimate_kd_tree(PrimitiveSetView primitives, const BuildOptions& options) {
    check(options);
    if (primitives.size() < least_primitives) {
        BuildReport report;
        static_cast<void>(build_kd_tree(primitives, options, &report));
        return {static_cast<double>(report.statistics.reference_count),
                static_cast<double>(report.tree_bytes), static_cast<double>(report.peak_bytes),
                report.stages.wall_seconds()};
    }
    Probe probe(primitives, {}, {});
    run_with_threads(options.threads, [&] { probe = take_probe(primitives, one_in); });
    const Probe thinned = probe.thinned(thinned_to);
    static_cast<void>(build_probe(thinned, options));
    const ProbeBuild smaller = build_probe(thinned, options);
    const ProbeBuild larger = build_probe(probe, options);
    const double scale = static_cast<double>(primitives.size()) /
                         static_cast<double>(std::max<std::uint64_t>(1, probe.centered_count()));
    const BuildReport& report = larger.report;
    return {scale * static_cast<double>(report.statistics.reference_count),
            scale * static_cast<double>(report.tree_bytes),
            scale * static_cast<double>(report.peak_bytes),
            scale * larger.size * extrapolated_seconds(smaller, larger, scale)};
}

Estimate estimate_wide_bvh(TriangleMeshView mesh, const BuildOptions& options) {
    check(options);
    // Stretches of the mesh serve as pieces: no triangle is ever cut.
    const auto stretch = static_cast<std::uint32_t>(
        std::max<std::size_t>(1, mesh.triangles().size() / (one_in * stretch_count)));
    const bool is_small = mesh.size() < least_primitives;
    std::vector<TriangleIndices> probe;
    for (std::size_t first = 0; first < mesh.size(); first += is_small ? 1 : one_in * stretch) {
        const auto rest = mesh.triangles().subspan(first);
        const auto part = rest.first(std::min<std::size_t>(is_small ? 1 : stretch, rest.size()));
        probe.insert(probe.end(), part.begin(), part.end());
    }
    BuildOptions probing = options;
    const bool is_sampled = mesh.size() >= options.wide.sampled_from;
    probing.wide.sampled_from = is_sampled ? 0 : std::numeric_limits<std::uint32_t>::max();
    const auto build = [&](std::span<const TriangleIndices> triangles) {
        ProbeBuild built{static_cast<double>(triangles.size()), 0.0, {}};
        static_cast<void>(build_wide_bvh({mesh.vertices(), triangles}, probing, &built.report));
        built.seconds = built.report.stages.wall_seconds();
        return built;
    };
    const auto quarter =
        std::span(probe).first(is_small ? probe.size() : probe.size() / thinned_to);
    static_cast<void>(build(quarter));
    const ProbeBuild smaller = build(quarter);
    const ProbeBuild larger = build(probe);
    const double scale = mesh.size() == 0 ? 0.0 : mesh.size() / larger.size;
    const BuildReport& report = larger.report;
    return {scale * static_cast<double>(report.statistics.reference_count),
            scale * static_cast<double>(report.tree_bytes),
            scale * static_cast<double>(report.peak_bytes),
            scale * larger.size * extrapolated_seconds(smaller, larger, std::max(1.0, scale))};
}

}  // namespace coppice
