#pragma once

#include "coppice/base/timer.h"
#include "coppice/geom/triangle_mesh.h"

#include "bench/answers.h"
#include "bench/bench.h"
#include "bench/entry.h"
#include "text/remaining_time.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coppice::lab {

/// What all scenes of a benchmark share.
struct BenchRun {
    const BenchOptions& options;
    const BenchObserver& observer;
    RemainingTime remaining;

    void tell(const std::string& step) const {
        if (observer.on_progress) observer.on_progress(step, remaining.seconds());
    }

    [[nodiscard]] std::size_t contestant_count() const {
        return options.methods.size() + options.peers.size();
    }

    /// The work of one turn, in the unit of the remaining time: triangles and rays.
    [[nodiscard]] double work_of_turn(std::uint64_t triangle_count) const {
        const double pixel_count = static_cast<double>(options.size) * options.size;
        return static_cast<double>(triangle_count) +
               pixel_count * static_cast<double>(options.rays.size());
    }
};

/// Measures all contestants on one scene, with one number of threads after the other. Contestants
/// take turns: what disturbs the machine disturbs them alike.
class SceneBench {
public:
    /// Chooses the camera and the light, and notes them in `scene`. Mesh, run and scene must
    /// outlive the object.
    SceneBench(BenchRun& run, BenchScene& scene, TriangleMeshView mesh);

    /// The rows by threads, then contestants. Throws Error(limit) for a build that would pass the
    /// memory limit.
    [[nodiscard]] std::vector<BenchRow> run_all();

private:
    void run_first_round(std::vector<BenchEntry>& entries);
    void build_first(BenchEntry& entry, bool is_reference);
    [[nodiscard]] BuildFigures build_within_limit(const BenchEntry& entry) const;
    void compare(BenchEntry& entry, RayKind kind, bool is_reference);
    void make_secondary_rays(std::span<const Hit> hits);
    void measure(BenchEntry& entry, int run);
    void measure_tracing(BenchEntry& entry, RayKind kind);
    void begin_turn(const BenchEntry& entry, const std::string& what) const;
    void end_turn(BenchEntry& entry, const Timer& timer);
    [[nodiscard]] bool asks_for(RayKind kind) const;

    BenchRun& run_;
    BenchScene& scene_;
    TriangleMeshView mesh_;
    std::array<std::vector<Ray>, 3> rays_;  // by RayKind
    std::array<Answers, 3> expected_;       // the reference's
    Answers answers_;                       // of the turn that runs
};

}  // namespace coppice::lab
