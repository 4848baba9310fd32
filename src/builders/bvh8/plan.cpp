#include "builders/bvh8/plan.h"

#include <algorithm>

namespace coppice::inline v0::bvh8 {
namespace {

// The number of rays per triangle from which the quality preset pays: the extra build time per
// triangle over the time saved per ray (docs/decisions/0005).
constexpr double quality_from = 30.0;

// The greatest number of references per triangle. Of 1.1, 1.15 and 1.25, the first gives up a third
// of the gain of spatial splits in the forest scene and nothing elsewhere, and stays within 56
// bytes a triangle.
constexpr double most_references = 1.1;

Bvh8Preset choose_preset(const Bvh8Options& options, std::uint32_t triangle_count) {
    if (options.preset != Bvh8Preset::automatic) return options.preset;
    const double rays_a_triangle = options.expected_rays / std::max(1U, triangle_count);
    return rays_a_triangle >= quality_from ? Bvh8Preset::quality : Bvh8Preset::fast;
}

}  // namespace

Plan make_plan(const Bvh8Options& options, std::uint32_t triangle_count) {
    const Bvh8Preset preset = choose_preset(options, triangle_count);
    Plan plan{preset, false, 4096, 1.0, options.sample};
    const bool is_automatic = options.preset == Bvh8Preset::automatic;
    if (is_automatic && preset != Bvh8Preset::quality && plan.sampling.rate == 1.0) {
        plan.sampling.rate = 0.01;
        plan.sampling.sampler = preset_sampler;
    }
    switch (preset) {
        case Bvh8Preset::automatic:
        case Bvh8Preset::fast:
            break;
        case Bvh8Preset::balanced:
            plan.by_planes = true;
            plan.cell_size = 32768;
            break;
        case Bvh8Preset::quality:
            plan.room = most_references;
            plan.cell_size = 16384;
            break;
    }
    if (options.cell_size != 0) plan.cell_size = options.cell_size;
    if (triangle_count < options.sampled_from) plan.sampling.rate = 1.0;
    return plan;
}

Bvh8Options scaled_down(const Bvh8Options& options, std::uint32_t triangle_count, double share) {
    const Plan plan = make_plan(options, triangle_count);
    Bvh8Options scaled = options;
    scaled.sample = plan.sampling;
    scaled.preset = choose_preset(options, triangle_count);
    scaled.sampled_from = 0;
    scaled.cell_size = std::max(64U, static_cast<std::uint32_t>(share * plan.cell_size));
    return scaled;
}

}  // namespace coppice::inline v0::bvh8
