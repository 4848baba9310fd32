#include "coppice/trace/bvh8_tracer.h"

#include "base/batch.h"
#include "base/rows.h"
#include "trace/hit_list.h"
#include "trace/kernels/bvh8_trace.h"

#include <utility>

namespace coppice::inline v0 {

Bvh8Tracer::Bvh8Tracer(Bvh8 tree) : Bvh8Tracer(std::move(tree), choose_isa()) {}

Bvh8Tracer::Bvh8Tracer(Bvh8 tree, Isa isa)
    : tree_(std::move(tree)), kernels_(&trace_kernels_for(isa)) {}

std::optional<Hit> Bvh8Tracer::intersect(const Ray& ray) const noexcept {
    std::optional<Hit> hit(std::in_place);
    if (!kernels_->closest(tree_, ray, *hit)) hit.reset();
    return hit;
}

bool Bvh8Tracer::occluded(const Ray& ray) const noexcept {
    return kernels_->any(tree_, ray);
}

std::optional<Hit> Bvh8Tracer::intersect(const Ray& ray, TraversalCounts& counts) const noexcept {
    std::optional<Hit> hit(std::in_place);
    if (!kernels_->closest_counting(tree_, ray, *hit, counts)) hit.reset();
    return hit;
}

bool Bvh8Tracer::occluded(const Ray& ray, TraversalCounts& counts) const noexcept {
    return kernels_->any_counting(tree_, ray, counts);
}

std::size_t Bvh8Tracer::intersect_all(const Ray& ray, std::span<Hit> hits,
                                      const Hit* after) const noexcept {
    return kernels_->first(tree_, ray, hits, after);
}

std::size_t Bvh8Tracer::count_hits(const Ray& ray) const noexcept {
    return count_by(
        [&](std::span<Hit> hits, const Hit* after) { return intersect_all(ray, hits, after); });
}

void Bvh8Tracer::intersect(std::span<const Ray> rays, std::span<Hit> hits, int threads) const {
    require_room("intersect", rays.size(), hits.size());
    run_queries(rays.size(), threads, [&](std::size_t begin, std::size_t end) {
        kernels_->closest_of_each(tree_, rays.subspan(begin, end - begin),
                                  hits.subspan(begin, end - begin));
    });
}

void Bvh8Tracer::occluded(std::span<const Ray> rays, std::span<std::uint8_t> is_occluded,
                          int threads) const {
    require_room("occluded", rays.size(), is_occluded.size());
    run_queries(rays.size(), threads, [&](std::size_t begin, std::size_t end) {
        kernels_->any_of_each(tree_, rays.subspan(begin, end - begin),
                              is_occluded.subspan(begin, end - begin));
    });
}

void Bvh8Tracer::intersect_all(std::span<const Ray> rays, std::span<Hit> hits,
                               std::span<std::size_t> counts, int threads) const {
    require_room("intersect_all", rays.size(), counts.size());
    for_each_row(
        "intersect_all", rays.size(), hits, threads,
        [&](std::size_t i, std::span<Hit> row) { counts[i] = intersect_all(rays[i], row); });
}

void Bvh8Tracer::count_hits(std::span<const Ray> rays, std::span<std::size_t> counts,
                            int threads) const {
    require_room("count_hits", rays.size(), counts.size());
    for_each_query(rays.size(), threads, [&](std::size_t i) { counts[i] = count_hits(rays[i]); });
}

}  // namespace coppice::inline v0
