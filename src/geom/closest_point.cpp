// Computes the closest point of a triangle. It is the closest point of the three edges, or the
// projection onto the face if that falls inside the triangle and is closer. All candidates are
// convex combinations of the corners. So the result is a point of the triangle, up to the rounding
// of a double, however thin the triangle is. For a triangle with hardly any area the distance may
// come out too large, but never too small. An edge is measured from its lexicographically smaller
// end, so that both of its triangles compute the same number.
// Source: [Ericson2005] sec. 5.1.5, which first determines the Voronoi region.

#include "coppice/geom/closest_point.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace coppice::inline v0 {
namespace {

// A candidate for the closest point, relative to the query point.
struct Candidate {
    double distance_squared;
    Vec3d place;
    std::array<double, 3> weights;
    TriangleFeature feature;
};

TriangleFeature corner_feature(std::size_t corner) noexcept {
    return static_cast<TriangleFeature>(static_cast<std::size_t>(TriangleFeature::corner_0) +
                                        corner);
}

TriangleFeature edge_feature(std::size_t edge) noexcept {
    return static_cast<TriangleFeature>(static_cast<std::size_t>(TriangleFeature::edge_0) + edge);
}

Candidate at_corner(const std::array<Vec3d, 3>& corners, std::size_t corner) noexcept {
    Candidate at{
        dot(corners[corner], corners[corner]), corners[corner], {}, corner_feature(corner)};
    at.weights[corner] = 1.0;
    return at;
}

Candidate on_edge(const Triangle& triangle, const std::array<Vec3d, 3>& corners,
                  std::size_t edge) noexcept {
    const auto key = [&](std::size_t i) {
        return std::tie(triangle[i].x, triangle[i].y, triangle[i].z);
    };
    std::size_t from = edge;
    std::size_t to = (edge + 1) % 3;
    if (key(to) < key(from)) std::swap(from, to);
    const Vec3d along = corners[to] - corners[from];
    const double length_squared = dot(along, along);
    const double reach = -dot(corners[from], along);
    if (!(reach > 0.0)) return at_corner(corners, from);
    if (reach >= length_squared) return at_corner(corners, to);
    const double share = reach / length_squared;
    const Vec3d place = corners[from] + share * along;
    Candidate at{dot(place, place), place, {}, edge_feature(edge)};
    at.weights[from] = 1.0 - share;
    at.weights[to] = share;
    return at;
}

// The projection onto the face, or a candidate at infinite distance if it falls outside.
Candidate on_face(const std::array<Vec3d, 3>& corners) noexcept {
    Candidate at{Aabb::infinity, {}, {}, TriangleFeature::face};
    const Vec3d normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        at.weights[i] = dot(normal, cross(corners[(i + 1) % 3], corners[(i + 2) % 3]));
        if (!(at.weights[i] >= 0.0)) return at;
        sum += at.weights[i];
    }
    if (!(sum > 0.0)) return at;
    for (std::size_t i = 0; i < 3; ++i) {
        at.weights[i] /= sum;
    }
    at.place = corners[0] + (at.weights[1] * (corners[1] - corners[0]) +
                             at.weights[2] * (corners[2] - corners[0]));
    at.distance_squared = dot(at.place, at.place);
    return at;
}

// An upper bound of the rounding error of the difference of two squared distances. The face counts
// as closer only beyond this bound. Otherwise rounding would decide at random between edge and face
// for a point above an edge.
double rounding_of(const Candidate& best, const std::array<Vec3d, 3>& corners) noexcept {
    double reach_squared = 0.0;
    for (const Vec3d& corner : corners) {
        reach_squared = std::max(reach_squared, dot(corner, corner));
    }
    return 0x1.0p-48 * best.distance_squared + 0x1.0p-96 * reach_squared;
}

}  // namespace

ClosestPoint closest_point(const Triangle& triangle, Vec3f to) noexcept {
    const Vec3d origin = to_double(to);
    const std::array<Vec3d, 3> corners{to_double(triangle[0]) - origin,
                                       to_double(triangle[1]) - origin,
                                       to_double(triangle[2]) - origin};
    Candidate best = on_edge(triangle, corners, 0);
    for (const Candidate& other : {on_edge(triangle, corners, 1), on_edge(triangle, corners, 2)}) {
        if (other.distance_squared < best.distance_squared) best = other;
    }
    const Candidate inside = on_face(corners);
    if (inside.distance_squared < best.distance_squared - rounding_of(best, corners)) best = inside;
    return {best.distance_squared, to_float(origin + best.place),
            static_cast<float>(best.weights[1]), static_cast<float>(best.weights[2]), best.feature};
}

}  // namespace coppice::inline v0
