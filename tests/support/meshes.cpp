#include "support/meshes.h"

#include "support/random.h"

#include <array>
#include <cmath>
#include <numbers>

namespace coppice::test {
namespace {

constexpr Aabb unit_cube{{0, 0, 0}, {1, 1, 1}};

std::uint32_t add_vertex(TriangleMesh& mesh, Vec3f vertex) {
    mesh.vertices.push_back(vertex);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void add_quad(TriangleMesh& mesh, const std::array<std::uint32_t, 4>& corners) {
    mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    mesh.triangles.push_back({corners[0], corners[2], corners[3]});
}

// Quads between the vertices of a grid that stands row by row.
void add_grid_quads(TriangleMesh& mesh, std::uint32_t cells) {
    for (std::uint32_t j = 0; j < cells; ++j) {
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t corner = j * (cells + 1) + i;
            add_quad(mesh, {corner, corner + 1, corner + cells + 2, corner + cells + 1});
        }
    }
}

void add_box(TriangleMesh& mesh, Vec3f lower, Vec3f size) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (unsigned corner = 0; corner < 8; ++corner) {
        add_vertex(mesh, {lower.x + ((corner & 1U) != 0 ? size.x : 0.0F),
                          lower.y + ((corner & 2U) != 0 ? size.y : 0.0F),
                          lower.z + ((corner & 4U) != 0 ? size.z : 0.0F)});
    }
    constexpr std::array<std::array<std::uint32_t, 4>, 6> faces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& face : faces) {
        add_quad(mesh, {first + face[0], first + face[1], first + face[2], first + face[3]});
    }
}

}  // namespace

void add_triangle(TriangleMesh& mesh, const Triangle& triangle) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), triangle.begin(), triangle.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
}

TriangleMesh make_triangle(const Triangle& triangle) {
    TriangleMesh mesh;
    add_triangle(mesh, triangle);
    return mesh;
}

TriangleMesh make_soup(std::uint32_t count, float size, std::uint64_t seed) {
    Random random(seed);
    const Aabb around{{-size, -size, -size}, {size, size, size}};
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3f corner = random.in_box(unit_cube);
        add_triangle(mesh,
                     {corner, corner + random.in_box(around), corner + random.in_box(around)});
    }
    return mesh;
}

TriangleMesh make_sphere(std::uint32_t rings, std::uint32_t segments) {
    TriangleMesh mesh;
    const std::uint32_t south = add_vertex(mesh, {0, 0, -1});
    for (std::uint32_t ring = 1; ring < rings; ++ring) {
        const double latitude = std::numbers::pi * (ring / static_cast<double>(rings) - 0.5);
        for (std::uint32_t k = 0; k < segments; ++k) {
            const double longitude = 2.0 * std::numbers::pi * (k + 0.3) / segments;
            add_vertex(mesh,
                       to_float({std::cos(latitude) * std::cos(longitude),
                                 std::cos(latitude) * std::sin(longitude), std::sin(latitude)}));
        }
    }
    const std::uint32_t north = add_vertex(mesh, {0, 0, 1});
    for (std::uint32_t k = 0; k < segments; ++k) {
        const std::uint32_t next = (k + 1) % segments;
        mesh.triangles.push_back({south, 1 + next, 1 + k});
        for (std::uint32_t ring = 0; ring + 2 < rings; ++ring) {
            const std::uint32_t row = 1 + ring * segments;
            add_quad(mesh, {row + k, row + next, row + segments + next, row + segments + k});
        }
        const std::uint32_t last_row = 1 + (rings - 2) * segments;
        mesh.triangles.push_back({last_row + k, last_row + next, north});
    }
    return mesh;
}

TriangleMesh make_terrain(std::uint32_t cells, std::uint64_t seed) {
    Random random(seed);
    const double phase = 6.0 * random.unit();
    TriangleMesh mesh;
    for (std::uint32_t j = 0; j <= cells; ++j) {
        for (std::uint32_t i = 0; i <= cells; ++i) {
            const double x = i / static_cast<double>(cells);
            const double y = j / static_cast<double>(cells);
            const double hills = std::sin(7.0 * x + phase) * std::cos(9.0 * y - phase) +
                                 0.3 * std::sin(31.0 * x * y + phase);
            add_vertex(mesh, to_float({x, y, 0.1 * hills + 0.002 * random.unit()}));
        }
    }
    add_grid_quads(mesh, cells);
    return mesh;
}

TriangleMesh make_sheet(std::uint32_t cells, Vec3f origin, Vec3f u, Vec3f v) {
    TriangleMesh mesh;
    for (std::uint32_t j = 0; j <= cells; ++j) {
        for (std::uint32_t i = 0; i <= cells; ++i) {
            add_vertex(mesh, origin + static_cast<float>(i) * u + static_cast<float>(j) * v);
        }
    }
    add_grid_quads(mesh, cells);
    return mesh;
}

TriangleMesh make_boxes(std::uint32_t count) {
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < count * count * count; ++i) {
        const std::uint32_t row = i / count;
        const std::uint32_t layer = row / count;
        const Vec3f cell{static_cast<float>(i % count), static_cast<float>(row % count),
                         static_cast<float>(layer)};
        add_box(mesh, 4.0F * cell, {2, 2, 3});
    }
    return mesh;
}

TriangleMesh make_slivers(std::uint32_t count, float width, std::uint64_t seed) {
    Random random(seed);
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3f from = random.in_box(unit_cube);
        const Vec3f to = random.in_box(unit_cube);
        add_triangle(mesh, {from, to, to + width * to_float(random.direction())});
    }
    return mesh;
}

TriangleMesh make_needles(std::uint32_t count, std::uint64_t seed) {
    Random random(seed);
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        Vec3f from = random.in_box(unit_cube);
        Vec3f to = random.in_box(unit_cube);
        const auto axis = static_cast<Axis>(i % 3);
        from[axis] = 0.0F;
        to[axis] = 1.0F;
        Vec3f beside = to;
        beside[next_axis(axis)] += 1e-3F;
        add_triangle(mesh, {from, to, beside});
    }
    return mesh;
}

TriangleMesh make_fan(std::uint32_t count) {
    TriangleMesh mesh;
    add_vertex(mesh, {0.5F, 0.5F, 0.5F});
    for (std::uint32_t k = 0; k <= count; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / count;
        add_vertex(mesh, to_float({0.5 + std::cos(angle), 0.5 + std::sin(angle), 0.25 * (k % 2)}));
        if (k > 0) mesh.triangles.push_back({0, k, k + 1});
    }
    return mesh;
}

TriangleMesh make_degenerate_points(std::uint32_t count, std::uint64_t seed) {
    Random random(seed);
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        add_vertex(mesh, random.in_box(unit_cube));
        mesh.triangles.push_back({i, i, i});
    }
    return mesh;
}

TriangleMesh make_collinear(std::uint32_t count, Vec3f direction, std::uint64_t seed) {
    Random random(seed);
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float begin = random.uniform(-1.0F, 1.0F);
        add_triangle(
            mesh, {begin * direction, (begin + 0.25F) * direction, (begin + 0.125F) * direction});
    }
    return mesh;
}

TriangleMesh repeated(TriangleMesh mesh, std::uint32_t times) {
    std::vector<TriangleIndices> triangles;
    for (const TriangleIndices& corners : mesh.triangles) {
        triangles.insert(triangles.end(), times, corners);
    }
    mesh.triangles = std::move(triangles);
    return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, float factor) {
    for (Vec3f& vertex : mesh.vertices) {
        vertex = factor * vertex;
    }
    return mesh;
}

TriangleMesh with_negative_zeros(TriangleMesh mesh, std::uint64_t seed) {
    Random random(seed);
    for (Vec3f& vertex : mesh.vertices) {
        for (const Axis axis : all_axes) {
            if (vertex[axis] == 0.0F && random.below(2) == 0) vertex[axis] = -0.0F;
        }
    }
    return mesh;
}

TriangleMesh joined(TriangleMesh first, const TriangleMesh& second) {
    const auto offset = static_cast<std::uint32_t>(first.vertices.size());
    first.vertices.insert(first.vertices.end(), second.vertices.begin(), second.vertices.end());
    for (const TriangleIndices& corners : second.triangles) {
        first.triangles.push_back({corners[0] + offset, corners[1] + offset, corners[2] + offset});
    }
    return first;
}

}  // namespace coppice::test
