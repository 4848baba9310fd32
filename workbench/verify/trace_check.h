#pragma once

#include "tracers/contestant.h"
#include "tracers/traced_tree.h"
#include "verify/exact_judge.h"
#include "verify/trace_options.h"
#include "verify/trace_results.h"

#include <memory>
#include <span>

namespace coppice::lab {

/// Compares hits with those of a reference, and has the exact judge look at every difference.
class HitCheck {
public:
    /// How many differences are kept in full.
    static constexpr std::size_t example_count = 5;

    /// Throws Error(invalid_argument) if this program was built without that reference.
    static void require(TraceCheck check);

    /// The mesh must outlive the check. `check` is not `none`; 0 threads are all.
    HitCheck(TriangleMeshView mesh, TraceCheck check, int threads);

    /// Compares all hits of one kind of rays. Of shadow rays a hit is one with a finite t.
    [[nodiscard]] TraceComparison compare(const TracedTree& tree, RayKind kind,
                                          std::span<const Ray> rays,
                                          std::span<const Hit> hits) const;

private:
    [[nodiscard]] std::vector<Hit> trace_reference(RayKind kind, std::span<const Ray> rays) const;
    [[nodiscard]] Hit reference_hit(const Ray& ray) const;
    void judge(const TracedTree& tree, RayKind kind, TraceDifference& difference) const;

    TriangleMeshView mesh_;
    TraceCheck check_;
    ExactJudge judge_;
    std::unique_ptr<Contestant> embree_;
};

}  // namespace coppice::lab
