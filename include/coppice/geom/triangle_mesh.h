#pragma once

#include "coppice/export.h"
#include "coppice/geom/aabb.h"
#include "coppice/geom/triangle.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// Three indices into a vertex array.
using TriangleIndices = std::array<std::uint32_t, 3>;

/// An indexed triangle mesh that does not own its arrays and must not outlive them. All indices
/// must be below vertices.size(): where a mesh enters the library (builders, SignedDistance,
/// validate()) that is checked, and queries rely on it. Satisfies PrimitiveSet: primitive i is
/// triangle i.
class COPPICE_EXPORT TriangleMeshView {
public:
    TriangleMeshView() = default;

    /// Throws Error(limit) for 2^32 triangles or more: ids have 32 bits.
    TriangleMeshView(std::span<const Vec3f> vertices, std::span<const TriangleIndices> triangles);

    /// The vertex positions.
    [[nodiscard]] std::span<const Vec3f> vertices() const noexcept { return vertices_; }

    /// The indices of each triangle.
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

    /// The box of triangle `id`; not finite unless all its corners are.
    [[nodiscard]] Aabb bounds(std::uint32_t id) const noexcept {
        return triangle_bounds_or_nan(triangle(id));
    }

    /// The box of the part of triangle `id` inside `box`; see clipped_triangle_bounds().
    [[nodiscard]] Aabb clipped_bounds(std::uint32_t id, const Aabb& box) const noexcept {
        return clipped_triangle_bounds(triangle(id), box);
    }

    /// The first triangle of [first, last) with an index that no vertex has, or `last`.
    [[nodiscard]] std::uint32_t first_invalid(std::uint32_t first,
                                              std::uint32_t last) const noexcept;

    /// Throws Error(invalid_argument) naming that triangle and the index, if there is one.
    void require_valid(std::uint32_t first, std::uint32_t last) const;

private:
    std::span<const Vec3f> vertices_;
    std::span<const TriangleIndices> triangles_;
};

/// An indexed triangle mesh that owns its arrays. All indices are below vertices.size(), and
/// counts are below 2^32.
struct TriangleMesh {
    std::vector<Vec3f> vertices;             ///< positions
    std::vector<TriangleIndices> triangles;  ///< three indices into `vertices` each

    /// A view that must not outlive the mesh.
    [[nodiscard]] TriangleMeshView view() const { return {vertices, triangles}; }
};

/// The box of the given points; empty for none.
[[nodiscard]] COPPICE_EXPORT Aabb bounds_of(std::span<const Vec3f> points) noexcept;

}  // namespace coppice::inline v0
