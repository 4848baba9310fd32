// What the fast and the slow test that no ray leaves a closed mesh share.
#pragma once

#include "coppice/base/parallel.h"
#include "coppice/builders/method.h"

#include "support/builds.h"
#include "support/inside_rays.h"
#include "support/isa.h"
#include "support/meshes.h"
#include "tracers/traced_tree.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <string>

namespace coppice::test {

/// Where meshes are moved to: floats are 1/64 apart there.
inline constexpr Vec3f far_away{148376.0F, 1234.0F, -223423.0F};

/// A cube around the origin whose faces are even grids, so that planes of trees, edges and rays
/// coincide.
[[nodiscard]] inline TriangleMesh make_grid_cube(std::uint32_t cells, float size) {
    TriangleMesh mesh;
    for (const Axis axis : all_axes) {
        for (const float side : {-size, size}) {
            Vec3f origin{-size, -size, -size};
            Vec3f u;
            Vec3f v;
            origin[axis] = side;
            u[next_axis(axis)] = 2.0F * size / static_cast<float>(cells);
            v[next_axis(next_axis(axis))] = u[next_axis(axis)];
            mesh = joined(std::move(mesh), make_sheet(cells, origin, u, v));
        }
    }
    return mesh;
}

/// What became of rays from inside of a mesh.
struct Escapes {
    std::uint64_t rays = 0;
    std::uint64_t misses = 0;      ///< rays that no hit was found for, or no occlusion
    std::uint64_t first_miss = 0;  ///< its number
};

/// Traces rays 0 to count - 1, on at most `threads` threads.
[[nodiscard]] inline Escapes count_escapes(const InsideRays& rays, const lab::TracedTree& tree,
                                           std::uint64_t count, int threads) {
    std::atomic<std::uint64_t> misses = 0;
    std::atomic<std::uint64_t> first = count;
    run_with_threads(threads, [&] {
        parallel_for_chunks(count, 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Ray ray = rays.make(i);
                if (tree.intersect(ray) && tree.occluded(ray)) continue;
                ++misses;
                std::uint64_t least = first;
                while (i < least && !first.compare_exchange_weak(least, i)) {
                }
            }
        });
    });
    return {count, misses, first};
}

/// Calls `use(name, tree)` with trees of all methods, each built and traced by each instruction
/// set.
template <typename Use>
void for_all_trees(const TriangleMesh& mesh, Use&& use) {
    for (const Method& method : method_registry()) {
        for (const Isa isa : available_isas()) {
            const ForceIsa force(isa);
            const lab::TracedTree tree(mesh.view(), options_as_if_large(method));
            use(std::string(method.name) + ", " + std::string(name_of(isa)), tree);
        }
    }
}

}  // namespace coppice::test
