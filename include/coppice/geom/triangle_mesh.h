#pragma once

#include "coppice/export.h"
#include "coppice/geom/aabb.h"
#include "coppice/geom/triangle.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// The indices of a triangle's three corners into a vertex array.
using TriangleIndices = std::array<std::uint32_t, 3>;

/// A view of an indexed triangle mesh. Does not own the arrays, which must outlive the view. Every
/// index must be less than vertices().size(): builders, SignedDistance and validate() check that,
/// and queries rely on it. Satisfies PrimitiveSet: primitive i is triangle i.
class COPPICE_EXPORT TriangleMeshView {
public:
    TriangleMeshView() = default;

    /// A view of a mesh. Throws Error(limit) for 2^32 triangles or more, since ids have 32
    /// bits.
    TriangleMeshView(std::span<const Vec3f> vertices, std::span<const TriangleIndices> triangles);

    /// The vertex positions.
    [[nodiscard]] std::span<const Vec3f> vertices() const noexcept { return vertices_; }

    /// The corner indices of all triangles.
    [[nodiscard]] std::span<const TriangleIndices> triangles() const noexcept { return triangles_; }

    /// Number of triangles.
    [[nodiscard]] std::uint32_t size() const noexcept {
        return static_cast<std::uint32_t>(triangles_.size());
    }

    /// The corners of triangle `id`, id < size().
    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept {
        const TriangleIndices& corner = triangles_[id];
        return {vertices_[corner[0]], vertices_[corner[1]], vertices_[corner[2]]};
    }

    /// The bounding box of triangle `id`. It is finite only if all corners are finite.
    [[nodiscard]] Aabb bounds(std::uint32_t id) const noexcept {
        return triangle_bounds_or_nan(triangle(id));
    }

    /// The bounding box of the part of triangle `id` inside `box`; see clipped_triangle_bounds().
    [[nodiscard]] Aabb clipped_bounds(std::uint32_t id, const Aabb& box) const noexcept {
        return clipped_triangle_bounds(triangle(id), box);
    }

    /// The first triangle of [first, last) with a vertex index out of range, or `last` if there is
    /// none.
    [[nodiscard]] std::uint32_t first_invalid(std::uint32_t first,
                                              std::uint32_t last) const noexcept;

    /// Throws Error(invalid_argument) naming the first triangle of [first, last) with a vertex
    /// index out of range, and the index, if there is one.
    void require_valid(std::uint32_t first, std::uint32_t last) const;

private:
    std::span<const Vec3f> vertices_;
    std::span<const TriangleIndices> triangles_;
};

/// An indexed triangle mesh that owns its arrays. Every index must be less than vertices.size(),
/// and there must be fewer than 2^32 triangles and vertices.
struct TriangleMesh {
    std::vector<Vec3f> vertices;             ///< positions
    std::vector<TriangleIndices> triangles;  ///< corner indices into `vertices`

    /// A view of this mesh, which must outlive the view.
    [[nodiscard]] TriangleMeshView view() const { return {vertices, triangles}; }
};

/// The bounding box of the given points; empty if there are none.
[[nodiscard]] COPPICE_EXPORT Aabb bounds_of(std::span<const Vec3f> points) noexcept;

}  // namespace coppice::inline v0
