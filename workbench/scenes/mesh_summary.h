#pragma once

#include "coppice/geom/aabb.h"
#include "coppice/geom/triangle_mesh.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace coppice::lab {

/// How many triangles have an area in [10^exponent, 10^(exponent + 1)).
struct AreaDecade {
    int exponent = 0;
    std::uint64_t count = 0;
};

/// How the areas of a mesh's triangles are distributed; all 0 for no triangles.
struct AreaDistribution {
    static constexpr std::array<int, 5> percents{1, 10, 50, 90, 99};

    double min = 0.0;
    double max = 0.0;
    double mean = 0.0;
    double total = 0.0;
    std::array<double, percents.size()> percentiles{};  ///< nearest rank, at `percents`
    std::uint64_t zero_count = 0;
    std::vector<AreaDecade> decades;  ///< of the areas above 0; ascending, without gaps
};

/// How triangles share their edges (pairs of vertex ids; edges of an id with itself not counted).
struct EdgeCounts {
    std::uint64_t edges = 0;
    std::uint64_t boundary = 0;      ///< edges of one triangle
    std::uint64_t non_manifold = 0;  ///< edges of three triangles or more
};

/// What `coppice info` tells about a mesh, beside its load report.
struct MeshSummary {
    std::uint64_t vertex_count = 0;
    std::uint64_t distinct_vertex_count = 0;
    std::uint64_t triangle_count = 0;
    Aabb bounds;  ///< of all vertices, used or not
    AreaDistribution areas;
    EdgeCounts edges;
};

/// Cost: O(n log n) time, 24 bytes per triangle.
[[nodiscard]] MeshSummary summarize(TriangleMeshView mesh);

/// Serializes all fields under their own names; percentiles as {"1": ..., "10": ...}.
void to_json(nlohmann::json& json, const MeshSummary& summary);

/// {"lower": [x, y, z], "upper": [x, y, z]}; null for an empty box.
[[nodiscard]] nlohmann::json bounds_json(const Aabb& bounds);

}  // namespace coppice::lab
