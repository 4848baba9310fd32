#pragma once

#include "coppice/base/rng.h"
#include "coppice/builders/build_on_sample.h"
#include "coppice/builders/draw_sample.h"
#include "coppice/builders/empty_leaves.h"
#include "coppice/builders/refill.h"
#include "coppice/geom/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace coppice::bench {

// A lambda in its place would be run by the compiler, for seconds in each source, and given up.
[[nodiscard]] inline TriangleMesh make_terrain() {
    constexpr std::uint32_t cells = 224;
    TriangleMesh made;
    for (std::uint32_t j = 0; j <= cells; ++j) {
        for (std::uint32_t i = 0; i <= cells; ++i) {
            const double x = i / static_cast<double>(cells);
            const double y = j / static_cast<double>(cells);
            const double z = 0.1 * std::sin(7.0 * x) * std::cos(9.0 * y) +
                             0.002 * random_unit(1, j * (cells + 1) + i);
            made.vertices.push_back(
                {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
        }
    }
    for (std::uint32_t j = 0; j < cells; ++j) {
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t corner = j * (cells + 1) + i;
            made.triangles.push_back({corner, corner + 1, corner + cells + 2});
            made.triangles.push_back({corner, corner + cells + 2, corner + cells + 1});
        }
    }
    return made;
}

/// The mesh that all micro benchmarks share: hilly ground with roughness, 224 x 224 cells, 100,352
/// triangles, seed 1.
[[nodiscard]] inline const TriangleMesh& terrain() {
    static const TriangleMesh mesh = make_terrain();
    return mesh;
}

/// Options with a sample rate in percent, as benchmarks take it, and the leaf limit scaled by it.
[[nodiscard]] inline KdOptions options_at(std::int64_t percent) {
    KdOptions options;
    options.sample.rate = static_cast<double>(percent) / 100.0;
    options.split.max_leaf = static_cast<std::uint32_t>(
        std::max(1.0, std::round(options.split.max_leaf * options.sample.rate)));
    return options;
}

/// The first stages' results, to start later ones from.
[[nodiscard]] inline KdTree sampled_tree(const KdOptions& options) {
    const TriangleMeshView triangles = terrain().view();
    return build_on_sample(triangles, draw_sample(triangles, options.sample), options);
}

[[nodiscard]] inline KdTree refilled_tree(const KdOptions& options) {
    return refill(empty_leaves(sampled_tree(options)), terrain().view(), options);
}

}  // namespace coppice::bench
