#include "rows/time_to_image.h"

namespace coppice::lab {

ImageRace find_image_race(std::span<const RateSummary> summaries) {
    ImageRace race;
    std::vector<TimeToImage> times;
    for (const RateSummary& summary : summaries) {
        if (!summary.ray_nanoseconds) continue;
        times.push_back({summary.total_seconds.mean, 1e-9 * summary.ray_nanoseconds->mean});
        race.trees.push_back({&summary, times.back()});
    }
    race.fastest = best_spans(times);
    for (std::size_t sooner = 0; sooner < times.size(); ++sooner) {
        for (std::size_t later = 0; later < times.size(); ++later) {
            const auto ray_count = break_even(times[sooner], times[later]);
            if (!ray_count || !(times[sooner].build < times[later].build)) continue;
            race.pairs.push_back({sooner, later, *ray_count});
        }
    }
    return race;
}

}  // namespace coppice::lab
