#pragma once

#include "coppice/geom/triangle.h"
#include "coppice/geom/triangle_mesh.h"

#include <cstdint>

namespace coppice::test {

/// Adds a triangle with corners of its own.
void add_triangle(TriangleMesh& mesh, const Triangle& triangle);

/// One triangle of its own.
[[nodiscard]] TriangleMesh make_triangle(const Triangle& triangle);

/// Triangles of edges up to `size` at random places of the unit cube.
[[nodiscard]] TriangleMesh make_soup(std::uint32_t count, float size, std::uint64_t seed);

/// A closed sphere of radius 1 around the origin: 2 segments (rings - 1) triangles; no vertex but
/// the poles lies on an axis.
[[nodiscard]] TriangleMesh make_sphere(std::uint32_t rings, std::uint32_t segments);

/// A height field over the unit square: 2 cells^2 triangles, sharing vertices.
[[nodiscard]] TriangleMesh make_terrain(std::uint32_t cells, std::uint64_t seed);

/// Two triangles per cell of a cells x cells grid, corner (i, j) at origin + i * u + j * v.
[[nodiscard]] TriangleMesh make_sheet(std::uint32_t cells, Vec3f origin, Vec3f u, Vec3f v);

/// Closed boxes with integer corners, side by side with gaps: 12 count^3 triangles.
[[nodiscard]] TriangleMesh make_boxes(std::uint32_t count);

/// Triangles of almost no width, `length` long at most, in all directions in the unit cube.
[[nodiscard]] TriangleMesh make_slivers(std::uint32_t count, float width, std::uint64_t seed);

/// Thin triangles from one face of the unit cube to the opposite one.
[[nodiscard]] TriangleMesh make_needles(std::uint32_t count, std::uint64_t seed);

/// `count` triangles around one shared vertex.
[[nodiscard]] TriangleMesh make_fan(std::uint32_t count);

/// `count` triangles whose corners are all the same vertex, each somewhere else in the unit cube.
[[nodiscard]] TriangleMesh make_degenerate_points(std::uint32_t count, std::uint64_t seed);

/// `count` triangles whose corners are on one line parallel to `direction`.
[[nodiscard]] TriangleMesh make_collinear(std::uint32_t count, Vec3f direction, std::uint64_t seed);

/// `mesh` with each triangle `times` times, copies next to each other.
[[nodiscard]] TriangleMesh repeated(TriangleMesh mesh, std::uint32_t times);

/// `mesh` with all vertices multiplied by `factor`.
[[nodiscard]] TriangleMesh scaled(TriangleMesh mesh, float factor);

/// `mesh` with every zero coordinate made -0 where `seed` says so.
[[nodiscard]] TriangleMesh with_negative_zeros(TriangleMesh mesh, std::uint64_t seed);

/// The vertices and triangles of both.
[[nodiscard]] TriangleMesh joined(TriangleMesh first, const TriangleMesh& second);

}  // namespace coppice::test
