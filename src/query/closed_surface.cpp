// The sign of a distance is the sign of the point's offset from the surface along a pseudonormal.
// That is the normal of the face, on an edge the sum of both faces' normals, and on a corner the
// sum of all its faces' normals weighted by their angles. With this weighting, and with no simpler
// one, the sign is right wherever the nearest point lies. Offsets are taken from a corner of the
// nearest feature rather than from the nearest point, because the corner is exact and the nearest
// point is rounded. Along an edge both give the same sign. Edges are matched by sorting, O(N log
// N).
// Source: [Baerentzen2005] sec. 3 and 4.

#include "query/closed_surface.h"

#include "coppice/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace coppice::inline v0 {
namespace {

constexpr std::uint32_t none = 0xffffffff;

Vec3d unit(Vec3d v) noexcept {
    const double length_squared = dot(v, v);
    return length_squared > 0.0 ? (1.0 / std::sqrt(length_squared)) * v : Vec3d{};
}

double angle_between(Vec3d a, Vec3d b) noexcept {
    const Vec3d normal = cross(a, b);
    return std::atan2(std::sqrt(dot(normal, normal)), dot(a, b));
}

auto key_of(Vec3f p) noexcept {
    return std::make_tuple(p.x + 0.0F, p.y + 0.0F, p.z + 0.0F);
}

// The vertices that triangles use. Unused vertices are left out: they may be NaN, which cannot be
// sorted.
std::vector<std::uint32_t> used_vertices(TriangleMeshView mesh) {
    mesh.require_valid(0, mesh.size());
    std::vector<bool> is_used(mesh.vertices().size(), false);
    for (const TriangleIndices& triangle : mesh.triangles()) {
        for (const std::uint32_t vertex : triangle) {
            is_used[vertex] = true;
        }
    }
    std::vector<std::uint32_t> used;
    for (std::uint32_t vertex = 0; vertex < is_used.size(); ++vertex) {
        if (is_used[vertex]) used.push_back(vertex);
    }
    return used;
}

std::string text_of(Vec3f p) {
    return fmt::format("({}, {}, {})", p.x, p.y, p.z);
}

}  // namespace

// An edge of one triangle, with its ends in ascending order.
struct ClosedSurface::EdgeSide {
    std::uint32_t lower;
    std::uint32_t upper;
    std::uint32_t triangle;
    std::uint8_t edge;
    bool is_forward;  // the triangle traverses it from lower to upper
};

ClosedSurface::ClosedSurface(TriangleMeshView mesh) {
    if (mesh.size() == 0) {
        throw Error(ErrorCode::unsupported, "the mesh is not closed: it has no triangles");
    }
    weld(mesh);
    connect();
    weigh_corners();
    double volume = 0.0;
    for (std::uint32_t id = 0; id < triangles_.size(); ++id) {
        volume += dot(corner(id, 0), cross(corner(id, 1), corner(id, 2)));
    }
    outward_ = volume < 0.0 ? -1.0 : 1.0;
}

void ClosedSurface::weld(TriangleMeshView mesh) {
    const std::span<const Vec3f> vertices = mesh.vertices();
    std::vector<std::uint32_t> order = used_vertices(mesh);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return key_of(vertices[a]) < key_of(vertices[b]);
    });
    std::vector<std::uint32_t> welded(vertices.size());
    for (const std::uint32_t vertex : order) {
        if (corners_.empty() || corners_.back() != vertices[vertex]) {
            corners_.push_back(vertices[vertex]);
        }
        welded[vertex] = static_cast<std::uint32_t>(corners_.size() - 1);
    }
    triangles_.reserve(mesh.size());
    for (const TriangleIndices& triangle : mesh.triangles()) {
        triangles_.push_back({welded[triangle[0]], welded[triangle[1]], welded[triangle[2]]});
    }
}

std::vector<ClosedSurface::EdgeSide> ClosedSurface::edge_sides() const {
    std::vector<EdgeSide> sides;
    sides.reserve(3 * triangles_.size());
    for (std::uint32_t id = 0; id < triangles_.size(); ++id) {
        for (std::uint8_t edge = 0; edge < 3; ++edge) {
            const std::uint32_t from = triangles_[id][edge];
            const std::uint32_t to = triangles_[id][(edge + 1U) % 3];
            if (from == to) continue;
            sides.push_back({std::min(from, to), std::max(from, to), id, edge, from < to});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const EdgeSide& a, const EdgeSide& b) {
        return std::tie(a.lower, a.upper, a.triangle, a.edge) <
               std::tie(b.lower, b.upper, b.triangle, b.edge);
    });
    return sides;
}

void ClosedSurface::connect() {
    across_.assign(triangles_.size(), {none, none, none});
    const std::vector<EdgeSide> sides = edge_sides();
    const EdgeSide* const end = sides.data() + sides.size();
    for (const EdgeSide* first = sides.data(); first != end;) {
        const EdgeSide* last = std::find_if(first, end, [&](const EdgeSide& side) {
            return side.lower != first->lower || side.upper != first->upper;
        });
        connect_edge(first, last);
        first = last;
    }
}

// Connects the two triangles of one edge, whose sides are [first, last).
void ClosedSurface::connect_edge(const EdgeSide* first, const EdgeSide* last) {
    std::array<const EdgeSide*, 2> sides{};
    std::size_t count = 0;
    for (const EdgeSide* side = first; side != last; ++side) {
        if (is_collapsed(side->triangle)) continue;
        if (count < 2) sides[count] = side;
        ++count;
    }
    const auto fail = [&](const std::string& what) {
        throw Error(
            ErrorCode::unsupported,
            fmt::format("the mesh is not closed: at the edge from {} to {} {}",
                        text_of(corners_[first->lower]), text_of(corners_[first->upper]), what));
    };
    if (count == 0) return;
    if (count == 1) fail(fmt::format("there is only triangle {}", sides[0]->triangle));
    if (count > 2) fail(fmt::format("there are {} triangles", count));
    if (sides[0]->is_forward == sides[1]->is_forward) {
        fail(fmt::format("triangles {} and {} are oriented against each other", sides[0]->triangle,
                         sides[1]->triangle));
    }
    for (const EdgeSide* side = first; side != last; ++side) {
        const bool is_first = side->triangle == sides[0]->triangle;
        across_[side->triangle][side->edge] = sides[is_first ? 1 : 0]->triangle;
    }
}

void ClosedSurface::weigh_corners() {
    corner_normals_.assign(corners_.size(), {});
    for (std::uint32_t id = 0; id < triangles_.size(); ++id) {
        const Vec3d normal = unit_normal(id);
        for (std::size_t at = 0; at < 3; ++at) {
            const double angle = angle_between(corner(id, (at + 1) % 3) - corner(id, at),
                                               corner(id, (at + 2) % 3) - corner(id, at));
            Vec3d& sum = corner_normals_[triangles_[id][at]];
            sum = sum + angle * normal;
        }
    }
}

Vec3d ClosedSurface::corner(std::uint32_t triangle, std::size_t at) const noexcept {
    return to_double(corners_[triangles_[triangle][at]]);
}

Vec3d ClosedSurface::unit_normal(std::uint32_t triangle) const noexcept {
    const Vec3d origin = corner(triangle, 0);
    return unit(cross(corner(triangle, 1) - origin, corner(triangle, 2) - origin));
}

// The pseudonormal of an edge. For a collapsed triangle it is that of the same edge of a neighbour
// that is not collapsed.
Vec3d ClosedSurface::edge_normal(std::uint32_t triangle, std::size_t edge) const noexcept {
    const std::uint32_t other = across_[triangle][edge];
    if (other == none) return {};
    if (!is_collapsed(triangle)) return unit_normal(triangle) + unit_normal(other);
    const std::uint32_t from = triangles_[triangle][edge];
    const std::uint32_t to = triangles_[triangle][(edge + 1) % 3];
    for (std::size_t same = 0; same < 3; ++same) {
        const std::uint32_t a = triangles_[other][same];
        const std::uint32_t b = triangles_[other][(same + 1) % 3];
        if ((a == from && b == to) || (a == to && b == from)) return edge_normal(other, same);
    }
    return {};
}

bool ClosedSurface::is_collapsed(std::uint32_t triangle) const noexcept {
    const TriangleIndices& t = triangles_[triangle];
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

bool ClosedSurface::is_inside(Vec3f point, const SurfaceNeighbor& nearest) const noexcept {
    const std::uint32_t id = nearest.prim;
    const auto feature = static_cast<std::size_t>(nearest.feature);
    const auto first_corner = static_cast<std::size_t>(TriangleFeature::corner_0);
    const auto first_edge = static_cast<std::size_t>(TriangleFeature::edge_0);
    std::size_t at = 0;
    Vec3d normal;
    if (feature >= first_corner) {
        at = feature - first_corner;
        normal = corner_normals_[triangles_[id][at]];
    } else if (feature >= first_edge) {
        at = feature - first_edge;
        normal = edge_normal(id, at);
    } else {
        normal = unit_normal(id);
    }
    return outward_ * dot(normal, to_double(point) - corner(id, at)) < 0.0;
}

}  // namespace coppice::inline v0
