#pragma once

#include "rows/seed_summary.h"
#include "statistics/break_even.h"

#include <cstddef>
#include <span>
#include <vector>

namespace coppice::lab {

/// A tree that was traced, and what an image costs with it: means over the seeds.
struct ImageTree {
    const RateSummary* summary = nullptr;
    TimeToImage time;
};

/// Two trees and the number of rays from which on the one that takes longer to build is ahead.
struct TreePair {
    std::size_t sooner = 0;  ///< the index of the tree that is built sooner
    std::size_t later = 0;
    double ray_count = 0.0;
};

/// Which tree has an image first.
struct ImageRace {
    std::vector<ImageTree> trees;
    std::vector<BestSpan> fastest;  ///< by number of rays
    std::vector<TreePair> pairs;    ///< all that have a break-even
};

/// The race of all traced trees of one scene; empty if none were. The summaries must outlive it.
[[nodiscard]] ImageRace find_image_race(std::span<const RateSummary> summaries);

}  // namespace coppice::lab
