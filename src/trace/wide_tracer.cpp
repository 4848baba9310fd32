#include "coppice/trace/wide_tracer.h"

#include "trace/kernels/wide_trace.h"

#include <utility>

namespace coppice {

WideTracer::WideTracer(WideBvh tree) : WideTracer(std::move(tree), choose_isa()) {}

WideTracer::WideTracer(WideBvh tree, Isa isa)
    : tree_(std::move(tree)),
      closest_(trace_kernels_for(isa).closest),
      any_(trace_kernels_for(isa).any) {}

std::optional<Hit> WideTracer::intersect(const Ray& ray) const noexcept {
    Hit hit;
    return closest_(tree_, ray, hit) ? std::optional(hit) : std::nullopt;
}

bool WideTracer::occluded(const Ray& ray) const noexcept {
    Hit hit;
    return any_(tree_, ray, hit);
}

}  // namespace coppice
