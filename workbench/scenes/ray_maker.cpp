#include "scenes/ray_maker.h"

#include "scenes/hard_rays.h"
#include "scenes/trace_rays.h"

#include <algorithm>
#include <cmath>

namespace coppice::lab {

std::vector<Ray> RayMaker::make(RayKind kind) {
    const auto size = static_cast<std::size_t>(options_.size);
    const std::size_t count = size * size;
    const std::uint64_t seed = options_.seed;
    switch (kind) {
        case RayKind::primary:
            return primary_rays(options_.camera, options_.size);
        case RayKind::random:
            return random_rays(mesh_, count, seed);
        case RayKind::axis:
            return axis_rays(mesh_, count, seed);
        case RayKind::grazing:
            return grazing_rays(mesh_, count, seed);
        case RayKind::shadow:
        case RayKind::diffuse:
            break;
    }
    see_surfaces();
    std::vector<Ray> rays = kind == RayKind::shadow
                                ? shadow_rays(mesh_, seen_rays_, seen_hits_, options_.light)
                                : diffuse_rays(mesh_, seen_rays_, seen_hits_, seed);
    rays.resize(std::min(rays.size(), count));
    return rays;
}

/// Primary rays for secondary ones to start from: so many that enough of them hit.
void RayMaker::see_surfaces() {
    if (!seen_rays_.empty()) return;
    const int size = options_.size;
    const std::size_t hit_count = look(size);
    const double count = static_cast<double>(size) * size;
    if (hit_count == 0 || hit_count == seen_rays_.size()) return;
    const double more = std::sqrt(1.05 * count / static_cast<double>(hit_count));
    look(static_cast<int>(std::min(4.0, more) * size) + 1);
}

std::size_t RayMaker::look(int size) {
    seen_rays_ = primary_rays(options_.camera, size);
    seen_hits_.resize(seen_rays_.size());
    trace_rays(tree_, RayKind::primary, seen_rays_, seen_hits_);
    return static_cast<std::size_t>(std::count_if(seen_hits_.begin(), seen_hits_.end(),
                                                  [](const Hit& hit) { return hit.is_hit(); }));
}

}  // namespace coppice::lab
