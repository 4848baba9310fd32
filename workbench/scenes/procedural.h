#pragma once

#include "coppice/geom/triangle_mesh.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace coppice::lab {

/// A kind of scene that needs no file: made of about as many triangles as asked for.
struct ProceduralScene {
    std::string_view name;
    std::string_view summary;
    TriangleMesh (*make)(std::uint32_t triangle_count, std::uint64_t seed);
};

inline constexpr std::uint32_t max_procedural_triangles = 100'000'000;

/// All kinds of procedural scenes.
[[nodiscard]] std::span<const ProceduralScene> procedural_registry();

/// A scene of about `triangle_count` triangles: within 5 % of it from 1,000 on, and never none.
/// Depends on the arguments alone. z points up; the extent is about 1 to 100.
/// Throws Error(invalid_argument) for an unknown name, naming those that exist, and unless
/// 1 <= triangle_count <= max_procedural_triangles.
[[nodiscard]] TriangleMesh make_procedural(std::string_view name, std::uint32_t triangle_count,
                                           std::uint64_t seed);

}  // namespace coppice::lab
