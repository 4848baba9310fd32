#include "scenes/trace_rays.h"

#include "coppice/base/parallel.h"

#include <cstdint>
#include <vector>

namespace coppice::lab {

namespace {

constexpr std::size_t chunk_size = 4096;

Hit hit_if(bool is_hit) {
    Hit hit;
    if (is_hit) hit.t = 0.0F;
    return hit;
}

}  // namespace

void trace_rays(const TracedTree& tree, RayKind kind, std::span<const Ray> rays,
                std::span<Hit> hits) {
    parallel_for_chunks(rays.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            hits[i] = kind == RayKind::shadow ? hit_if(tree.occluded(rays[i]))
                                              : tree.intersect(rays[i]).value_or(Hit{});
        }
    });
}

void trace_rays(const Contestant& contestant, RayKind kind, std::span<const Ray> rays,
                std::span<Hit> hits) {
    parallel_for_chunks(rays.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        const auto chunk = rays.subspan(begin, end - begin);
        const auto found = hits.subspan(begin, end - begin);
        if (kind != RayKind::shadow) {
            contestant.intersect(chunk, found, Queries::single);
            return;
        }
        std::vector<std::uint8_t> flags(chunk.size());
        contestant.occluded(chunk, flags, Queries::single);
        for (std::size_t i = 0; i < flags.size(); ++i) {
            found[i] = hit_if(flags[i] != 0);
        }
    });
}

void trace_counting(const TracedTree& tree, RayKind kind, std::span<const Ray> rays,
                    std::span<Hit> hits, std::span<TraversalCounts> counts) {
    parallel_for_chunks(rays.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            counts[i] = {};
            hits[i] = kind == RayKind::shadow ? hit_if(tree.occluded(rays[i], counts[i]))
                                              : tree.intersect(rays[i], counts[i]).value_or(Hit{});
        }
    });
}

}  // namespace coppice::lab
