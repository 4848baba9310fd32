#pragma once

#include <cstdint>

namespace coppice::inline v0 {

/// The work of traversals, summed over the rays that they were called for.
struct TraversalCounts {
    std::uint64_t nodes = 0;       ///< Inner nodes visited.
    std::uint64_t leaves = 0;      ///< Leaves visited, empty ones included.
    std::uint64_t primitives = 0;  ///< Primitives tested, repetitions included.

    /// Adds the counts of other rays.
    TraversalCounts& operator+=(const TraversalCounts& other) noexcept {
        nodes += other.nodes;
        leaves += other.leaves;
        primitives += other.primitives;
        return *this;
    }

    friend bool operator==(const TraversalCounts&, const TraversalCounts&) = default;
};

}  // namespace coppice::inline v0
