#pragma once

#include <cstdint>

namespace coppice::inline v0 {

/// What traversals did, summed over the rays they are given for.
struct TraversalCounts {
    std::uint64_t nodes = 0;       ///< Inner nodes visited.
    std::uint64_t leaves = 0;      ///< Leaves visited, empty ones included.
    std::uint64_t primitives = 0;  ///< Primitives tested, each time they are.

    /// Adds those of other rays.
    TraversalCounts& operator+=(const TraversalCounts& other) noexcept {
        nodes += other.nodes;
        leaves += other.leaves;
        primitives += other.primitives;
        return *this;
    }

    friend bool operator==(const TraversalCounts&, const TraversalCounts&) = default;
};

}  // namespace coppice::inline v0
