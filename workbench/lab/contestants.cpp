// Our own methods as contestants: built by the library's functions, traced by its single-ray
// queries, as a user would.

#include "coppice/base/timer.h"
#include "coppice/build/build_tree.h"
#include "coppice/trace/intersect.h"

#include "lab/contestant.h"

namespace coppice::lab {

namespace {

/// A k-d tree.
class KdContestant final : public Contestant {
public:
    explicit KdContestant(BuildOptions options) : options_(std::move(options)) {}

    BuildFigures build(TriangleMeshView mesh, bool is_measured) override {
        mesh_ = mesh;
        BuildReport report;
        const Timer wall;
        const CpuTimer cpu;
        tree_ = build_kd_tree(mesh, options_, is_measured ? &report : nullptr);
        figures_.wall_seconds = wall.seconds();
        figures_.cpu_seconds = cpu.seconds();
        if (is_measured) note(report);
        return figures_;
    }

    void clear() noexcept override { tree_ = {}; }

    void intersect(std::span<const Ray> rays, std::span<Hit> hits) const noexcept override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            hits[i] = coppice::intersect(tree_, mesh_, rays[i]).value_or(Hit{});
        }
    }

    void occluded(std::span<const Ray> rays,
                  std::span<std::uint8_t> flags) const noexcept override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            flags[i] = coppice::occluded(tree_, mesh_, rays[i]) ? 1 : 0;
        }
    }

private:
    void note(const BuildReport& report) {
        // The call did more than build: it measured.
        figures_.wall_seconds = report.stages.wall_seconds();
        figures_.cpu_seconds = report.stages.cpu_seconds();
        figures_.bytes = report.tree_bytes;
        figures_.peak_bytes = report.peak_bytes;
        figures_.sah_cost = report.statistics.sah_cost;
        figures_.reference_count = static_cast<double>(report.statistics.reference_count);
    }

    BuildOptions options_;
    TriangleMeshView mesh_;
    KdTree tree_;
    BuildFigures figures_;
};

}  // namespace

std::unique_ptr<Contestant> make_contestant(const Method& method, int threads) {
    BuildOptions options = method.options();
    options.threads = threads;
    return std::make_unique<KdContestant>(std::move(options));
}

}  // namespace coppice::lab
