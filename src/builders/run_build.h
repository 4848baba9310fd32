#pragma once

#include "coppice/base/memory_meter.h"
#include "coppice/builders/build_context.h"
#include "coppice/builders/build_control.h"
#include "coppice/builders/build_report.h"
#include "coppice/cost/measure.h"

#include "builders/stage_clock.h"

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace coppice::inline v0 {

/// A running build: collects the reports, times and memory of its stages.
class BuildRun {
public:
    /// `report` and `progress` must outlive it; `progress` may be null.
    BuildRun(BuildReport& report, Progress* progress) noexcept
        : report_(report), progress_(progress) {}

    [[nodiscard]] BuildReport& report() noexcept { return report_; }

    [[nodiscard]] BuildContext context() noexcept { return {&meter_, progress_}; }

    [[nodiscard]] std::uint64_t peak_bytes() const noexcept { return meter_.peak_bytes(); }

    /// Starts a part of the build that is `share` of the whole, for progress reports.
    void begin(double share) {
        if (progress_ != nullptr) progress_->begin_stage(share);
    }

    /// Runs a stage that is `share` of the whole and reports its times. `work()` returns its
    /// result, and `items(result)` the number of items in it.
    template <typename Work, typename Items>
    auto stage(StageReport& report, double share, Work&& work, Items&& items) {
        begin(share);
        auto result = work();
        report = clock_.lap(static_cast<std::uint64_t>(items(std::as_const(result))));
        return result;
    }

private:
    BuildReport& report_;
    Progress* progress_;
    MemoryMeter meter_;
    StageClock clock_;
};

/// The initial report of a build, with its options.
template <typename Options>
[[nodiscard]] BuildReport begin_report(const Options& options, std::uint32_t primitive_count) {
    BuildReport report;
    report.options = options;
    report.sample = options.sample;
    report.primitive_count = primitive_count;
    report.notes = notes_on(options, primitive_count);
    return report;
}

/// Runs `work(progress)` with at most `threads` threads, progress reports and cancellation as
/// `control` says. `progress` is null if progress is disabled. Throws Error(cancelled) after a stop
/// request.
void run_watched(int threads, const BuildControl& control,
                 const std::function<void(Progress*)>& work);

/// The common frame of all builds: runs `pipeline(run)`, which returns the tree, and measures it.
/// Measuring is `measure_share` of the whole.
template <typename Options, typename Pipeline>
[[nodiscard]] auto run_build(const Options& options, const BuildControl& control,
                             BuildReport& report, double measure_share, Pipeline&& pipeline) {
    std::invoke_result_t<Pipeline&, BuildRun&> tree;
    run_watched(options.threads, control, [&](Progress* progress) {
        BuildRun run(report, progress);
        tree = pipeline(run);
        report.tree_bytes = tree.byte_count();
        report.peak_bytes = std::max(run.peak_bytes(), report.tree_bytes);
        if (!control.is_measured) return;
        run.begin(measure_share);
        report.statistics = measure(tree, options.cost);
    });
    return tree;
}

/// True if a build stays within the memory limit, or there is none.
[[nodiscard]] bool is_within_limit(const BuildEstimate& estimate,
                                   const BuildControl& control) noexcept;

/// A number of bytes as readable text, e.g. "1.5 GiB".
[[nodiscard]] std::string bytes_text(double bytes);

/// The message for an exceeded memory limit, e.g. "WHAT would take about 1.5 GiB of memory beside
/// the 200 MiB of its primitives; the limit is 1 GiB".
[[nodiscard]] std::string excess_text(std::string_view what, const BuildEstimate& estimate,
                                      const BuildControl& control);

}  // namespace coppice::inline v0
