#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace coppice::lab {

/// What trees of one scene share that differ in their rate and seed only.
struct TreeSeries {
    std::string primitives;           ///< "points" or "triangles"
    std::string protocol;             ///< the builder's name: a protocol, method or peer
    std::string sampler = "uniform";  ///< "" for trees that are never sampled

    auto operator<=>(const TreeSeries&) const = default;

    /// What trees, and what is found of them, share with their series.
    [[nodiscard]] const TreeSeries& series() const noexcept { return *this; }
};

/// Which tree of an experiment.
struct TreeKey : TreeSeries {
    std::string scene;  ///< short and unique within the experiment
    double sample_percent = 100.0;
    std::uint64_t seed = 1;

    auto operator<=>(const TreeKey&) const = default;

    /// True if the other differs in nothing but the seed.
    [[nodiscard]] bool is_twin_of(const TreeKey& other) const {
        return series() == other.series() && sample_percent == other.sample_percent;
    }
};

}  // namespace coppice::lab
