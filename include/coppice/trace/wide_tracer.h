#pragma once

#include "coppice/base/cpu.h"
#include "coppice/geom/ray.h"
#include "coppice/tree/wide_bvh.h"

#include <optional>

namespace coppice {

/// Traces rays against a wide tree, with the kernels of one instruction set. Hits equal those of
/// brute_force_intersect() to the bit, the lowest id of equally close ones included. Queries are
/// reentrant, allocate nothing and never throw; a ray that is not traceable hits nothing.
class WideTracer {
public:
    /// Keeps the tree's arrays alive. Throws Error(invalid_argument) like choose_isa().
    explicit WideTracer(WideBvh tree);

    /// The same with the kernels of one of available_isas().
    WideTracer(WideBvh tree, Isa isa);

    /// The closest hit, or nothing.
    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const noexcept;

    /// True if the ray hits any triangle; stops at the first found.
    [[nodiscard]] bool occluded(const Ray& ray) const noexcept;

    [[nodiscard]] const WideBvh& tree() const noexcept { return tree_; }

private:
    using Trace = bool(const WideBvh&, const Ray&, Hit&) noexcept;

    WideBvh tree_;
    Trace* closest_;
    Trace* any_;
};

}  // namespace coppice
