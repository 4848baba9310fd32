// Our own methods as contestants: built by the library's functions, traced by its single-ray
// queries, as a user would.

#include "coppice/base/timer.h"
#include "coppice/build/build_tree.h"
#include "coppice/trace/intersect.h"
#include "coppice/trace/wide_tracer.h"

#include "lab/contestant.h"

namespace coppice::lab {

namespace {

// What a report says of the tree and, as the call that made it did more than build, of the times.
void note(const BuildReport& report, BuildFigures& figures) {
    figures.wall_seconds = report.stages.wall_seconds();
    figures.cpu_seconds = report.stages.cpu_seconds();
    figures.bytes = report.tree_bytes;
    figures.peak_bytes = report.peak_bytes;
    figures.sah_cost = report.statistics.sah_cost;
    figures.reference_count = static_cast<double>(report.statistics.reference_count);
}

// Builds by a callable that takes where to put a report, or null.
template <typename Build>
void build_into(BuildFigures& figures, bool is_measured, Build&& build) {
    BuildReport report;
    const Timer wall;
    const CpuTimer cpu;
    build(is_measured ? &report : nullptr);
    figures.wall_seconds = wall.seconds();
    figures.cpu_seconds = cpu.seconds();
    if (is_measured) note(report, figures);
}

class KdContestant final : public Contestant {
public:
    explicit KdContestant(BuildOptions options) : options_(std::move(options)) {}

    BuildFigures build(TriangleMeshView mesh, bool is_measured) override {
        mesh_ = mesh;
        build_into(figures_, is_measured,
                   [&](BuildReport* report) { tree_ = build_kd_tree(mesh, options_, report); });
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
    BuildOptions options_;
    TriangleMeshView mesh_;
    KdTree tree_;
    BuildFigures figures_;
};

class WideContestant final : public Contestant {
public:
    explicit WideContestant(BuildOptions options) : options_(std::move(options)) {}

    BuildFigures build(TriangleMeshView mesh, bool is_measured) override {
        build_into(figures_, is_measured, [&](BuildReport* report) {
            tracer_ = WideTracer(build_wide_bvh(mesh, options_, report));
        });
        return figures_;
    }

    void clear() noexcept override { tracer_ = WideTracer(WideBvh()); }

    void intersect(std::span<const Ray> rays, std::span<Hit> hits) const noexcept override {
        for (std::size_t i = 0; i < rays.size(); ++i)
            hits[i] = tracer_.intersect(rays[i]).value_or(Hit{});
    }

    void occluded(std::span<const Ray> rays,
                  std::span<std::uint8_t> flags) const noexcept override {
        for (std::size_t i = 0; i < rays.size(); ++i)
            flags[i] = tracer_.occluded(rays[i]) ? 1 : 0;
    }

private:
    BuildOptions options_;
    WideTracer tracer_{WideBvh()};
    BuildFigures figures_;
};

}  // namespace

std::unique_ptr<Contestant> make_contestant(const Method& method, int threads) {
    BuildOptions options = method.options();
    options.threads = threads;
    if (method.tree == TreeKind::wide) return std::make_unique<WideContestant>(std::move(options));
    return std::make_unique<KdContestant>(std::move(options));
}

}  // namespace coppice::lab
