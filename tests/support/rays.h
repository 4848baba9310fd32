#pragma once

#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/tree/kd_tree.h"

#include "support/random.h"

#include <array>
#include <string_view>

namespace coppice::test {

/// Rays of the kinds that traversals get wrong.
enum class RayKind {
    line,              ///< from a random point of the box's surface, inward
    between_points,    ///< from a random point around the box to one in it
    axis_parallel,     ///< through a vertex; zero components of either sign
    at_vertex,         ///< aimed at a vertex from anywhere
    at_edge,           ///< aimed at a point of an edge
    at_triangle,       ///< aimed at a point of a triangle
    in_split_plane,    ///< within a plane of the tree, through vertices where there are such
    from_split_plane,  ///< its origin on a plane of the tree
    limited            ///< as at_triangle, with t_min and t_max at or next to a hit
};

inline constexpr std::array all_ray_kinds{
    RayKind::line,           RayKind::between_points,   RayKind::axis_parallel,
    RayKind::at_vertex,      RayKind::at_edge,          RayKind::at_triangle,
    RayKind::in_split_plane, RayKind::from_split_plane, RayKind::limited};

/// The name of a kind, for messages.
[[nodiscard]] std::string_view name_of(RayKind kind) noexcept;

/// Makes rays for one mesh and a tree over it.
class RaySource {
public:
    RaySource(const TriangleMesh& mesh, const KdTree& tree, std::uint64_t seed);

    /// The next ray of a kind. Of an empty scene: any ray.
    [[nodiscard]] Ray next(RayKind kind);

private:
    [[nodiscard]] Vec3f vertex();
    [[nodiscard]] Vec3f point_of_triangle(bool on_edge);
    [[nodiscard]] Vec3f origin();
    [[nodiscard]] SplitPlane split_plane();
    [[nodiscard]] Ray axis_parallel();
    [[nodiscard]] Ray in_split_plane();
    [[nodiscard]] Ray from_split_plane();
    [[nodiscard]] Ray limited();

    TriangleMeshView mesh_;
    const KdTree& tree_;
    Aabb box_;
    Random random_;
};

/// A random line that meets a box, as a ray from where it enters: lines are uniform, that is, a
/// convex body inside the box is met with the probability that its surface area is of the box's.
[[nodiscard]] Ray random_line_through(const Aabb& box, Random& random);

/// A ray from one point to another and beyond; t = 1 at `to`.
[[nodiscard]] Ray ray_through(Vec3f from, Vec3f to) noexcept;

}  // namespace coppice::test
