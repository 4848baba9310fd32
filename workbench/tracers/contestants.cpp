// Our own methods as contestants: built by the library's functions, traced by its
// queries, as a user would.

#include "coppice/base/timer.h"
#include "coppice/builders/build_tree.h"
#include "coppice/trace/bvh8_tracer.h"
#include "coppice/trace/intersect.h"

#include "tracers/contestant.h"
#include "tracers/memory_limit.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace coppice::lab {

namespace {

/// The figures of a build, taken by `build(control)`, which returns its report.
template <typename Build>
BuildFigures figures_of(const BuildControl& control, BuildFigures last, Build&& build) {
    if (!control.is_measured) {
        const Timer wall;
        const CpuTimer cpu;
        static_cast<void>(build(control));
        last.wall_seconds = wall.seconds();
        last.cpu_seconds = cpu.seconds();
        return last;
    }
    const BuildReport report = build(control);
    // The call did more than build: it measured.
    return {report.stages.wall_seconds(),
            report.stages.cpu_seconds(),
            report.tree_bytes,
            report.peak_bytes,
            report.statistics.sah_cost,
            static_cast<double>(report.statistics.reference_count),
            report.sample_count / static_cast<double>(std::max(1U, report.primitive_count))};
}

/// The limit is that of the measured build alone: it would be estimated each time.
BuildControl control_of(bool is_measured, std::uint64_t memory_limit_bytes, TriangleMeshView mesh) {
    BuildControl control = limit_memory(is_measured ? memory_limit_bytes : 0, mesh);
    control.is_measured = is_measured;
    return control;
}

/// A k-d tree.
class KdContestant final : public Contestant {
public:
    KdContestant(KdOptions options, std::uint64_t memory_limit_bytes)
        : options_(std::move(options)), memory_limit_bytes_(memory_limit_bytes) {}

    BuildFigures build(TriangleMeshView mesh, bool is_measured) override {
        mesh_ = mesh;
        const BuildControl control = control_of(is_measured, memory_limit_bytes_, mesh);
        return figures_ = figures_of(control, figures_, [&](const BuildControl& how) {
                   auto [tree, report] = build_kd_tree(mesh, options_, how);
                   tree_ = std::move(tree);
                   return std::move(report);
               });
    }

    void clear() noexcept override { tree_ = {}; }

    // An array is traced one by one.
    void intersect(std::span<const Ray> rays, std::span<Hit> hits,
                   Queries /*queries*/) const noexcept override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            hits[i] = coppice::intersect(tree_, mesh_, rays[i]).value_or(Hit{});
        }
    }

    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> flags,
                  Queries /*queries*/) const noexcept override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            flags[i] = coppice::occluded(tree_, mesh_, rays[i]) ? 1 : 0;
        }
    }

private:
    KdOptions options_;
    std::uint64_t memory_limit_bytes_;
    TriangleMeshView mesh_;
    KdTree tree_;
    BuildFigures figures_;
};

/// An 8-wide tree.
class Bvh8Contestant final : public Contestant {
public:
    Bvh8Contestant(Bvh8Options options, std::uint64_t memory_limit_bytes)
        : options_(std::move(options)), memory_limit_bytes_(memory_limit_bytes) {}

    BuildFigures build(TriangleMeshView mesh, bool is_measured) override {
        const BuildControl control = control_of(is_measured, memory_limit_bytes_, mesh);
        return figures_ = figures_of(control, figures_, [&](const BuildControl& how) {
                   auto [tree, report] = build_bvh8(mesh, options_, how);
                   tracer_.emplace(std::move(tree));
                   options_.sample = report.sample;
                   options_.preset = report.preset;
                   return std::move(report);
               });
    }

    void clear() noexcept override { tracer_.reset(); }

    void intersect(std::span<const Ray> rays, std::span<Hit> hits,
                   Queries queries) const noexcept override {
        if (queries != Queries::single) return tracer_->intersect(rays, hits, 1);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            hits[i] = tracer_->intersect(rays[i]).value_or(Hit{});
        }
    }

    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> flags,
                  Queries queries) const noexcept override {
        if (queries != Queries::single) return tracer_->occluded(rays, flags, 1);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            flags[i] = tracer_->occluded(rays[i]) ? 1 : 0;
        }
    }

private:
    Bvh8Options options_;
    std::uint64_t memory_limit_bytes_;
    std::optional<Bvh8Tracer> tracer_;
    BuildFigures figures_;
};

}  // namespace

std::unique_ptr<Contestant> make_contestant(const Variant& variant, int threads,
                                            std::uint64_t memory_limit_bytes) {
    BuildOptions options = variant.options;
    set_threads(options, threads);
    if (auto* const kd = std::get_if<KdOptions>(&options)) {
        return std::make_unique<KdContestant>(std::move(*kd), memory_limit_bytes);
    }
    return std::make_unique<Bvh8Contestant>(std::get<Bvh8Options>(std::move(options)),
                                            memory_limit_bytes);
}

}  // namespace coppice::lab
