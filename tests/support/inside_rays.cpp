// Points are inside if rays from them into three directions cross the surface an odd number of
// times: in a closed mesh that is so for any direction that meets no edge, and three do not lie
// alike. These rays are counted by a tree of the simplest kind.

#include "support/inside_rays.h"

#include "coppice/builders/build_tree.h"
#include "coppice/trace/intersect.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace coppice::test {
namespace {

constexpr std::size_t wanted_points = 4000;

bool is_inside(const KdTree& tree, TriangleMeshView mesh, Vec3f point, Random& random) {
    for (int i = 0; i < 3; ++i) {
        const Ray ray{.origin = point, .direction = to_float(random.direction())};
        if (count_hits(tree, mesh, ray) % 2 == 0) return false;
    }
    return true;
}

Vec3d middle(const Triangle& triangle) {
    return (1.0 / 3.0) * (to_double(triangle[0]) + to_double(triangle[1]) + to_double(triangle[2]));
}

// The planes of a k-d tree and the sides of an 8-wide tree's boxes, sorted.
std::array<std::vector<float>, 3> planes_of(const KdTree& planes, const Bvh8& boxes) {
    std::array<std::vector<float>, 3> found;
    for (const KdNode& node : planes.nodes()) {
        if (node.is_leaf()) continue;
        found[static_cast<std::size_t>(node.plane().axis)].push_back(node.plane().position);
    }
    for (const Bvh8Node& node : boxes.nodes()) {
        for (std::size_t slot = 0; slot < bvh8_width && !node.child[slot].is_empty(); ++slot) {
            for (std::size_t side = 0; side < 6; ++side) {
                found[side % 3].push_back(node.bound[side][slot]);
            }
        }
    }
    for (std::vector<float>& positions : found) {
        std::sort(positions.begin(), positions.end());
    }
    return found;
}

}  // namespace

InsideRays::InsideRays(const TriangleMesh& mesh, std::uint64_t seed)
    : mesh_(mesh.view()), seed_(seed) {
    const KdTree tree = build_kd_tree(mesh_).tree;
    const auto planes = planes_of(tree, build_bvh8(mesh_).tree);
    Random random(seed);
    for (std::size_t i = 0; i < 20 * wanted_points && points_.size() < wanted_points; ++i) {
        const Vec3d from = middle(mesh_.triangle(random.below(mesh_.size())));
        const Vec3d to = middle(mesh_.triangle(random.below(mesh_.size())));
        const Vec3f point = to_float(from + random.unit() * (to - from));
        if (!is_inside(tree, mesh_, point, random)) continue;
        points_.push_back(point);
        const auto axis = static_cast<Axis>(random.below(3));
        const auto& positions = planes[static_cast<std::size_t>(axis)];
        const auto next = std::lower_bound(positions.begin(), positions.end(), point[axis]);
        if (next == positions.end()) continue;
        Vec3f moved = point;
        moved[axis] = *next;
        if (is_inside(tree, mesh_, moved, random)) plane_points_.push_back({moved, axis});
    }
    if (plane_points_.empty()) throw std::runtime_error("nothing is inside");
}

Vec3f InsideRays::target(Random& random) const {
    const Triangle triangle = mesh_.triangle(random.below(mesh_.size()));
    if (random.below(2) == 0) return triangle[0];
    const Vec3d a = to_double(triangle[1]);
    const double share = random.below(2) == 0 ? 0.5 : random.unit();
    return to_float(a + share * (to_double(triangle[2]) - a));
}

Ray InsideRays::in_plane(Random& random) const {
    const auto count = static_cast<std::uint32_t>(plane_points_.size());
    const PlanePoint& from = plane_points_[random.below(count)];
    const bool is_aimed = random.below(2) == 0;
    Ray ray{.origin = from.point,
            .direction = is_aimed ? target(random) - from.point : to_float(random.direction())};
    ray.direction[from.axis] = random.below(2) == 0 ? 0.0F : -0.0F;
    if (random.below(4) == 0) ray.direction[next_axis(from.axis)] = 0.0F;
    return ray;
}

Ray InsideRays::make(std::uint64_t number) const {
    Random random(random_bits(seed_, number));
    Ray ray{.origin = points_[random.below(static_cast<std::uint32_t>(points_.size()))]};
    switch (number % 3) {
        case 0:
            ray.direction = to_float(random.direction());
            break;
        case 1:
            ray.direction = target(random) - ray.origin;
            break;
        default:
            ray = in_plane(random);
            break;
    }
    if (ray.direction == Vec3f{}) ray.direction = {1.0F, 0.0F, 0.0F};
    return ray;
}

TriangleMesh on_grid(TriangleMesh mesh, float step, Vec3f moved_by) {
    for (Vec3f& vertex : mesh.vertices) {
        for (const Axis axis : all_axes) {
            vertex[axis] = step * std::round(vertex[axis] / step) + moved_by[axis];
        }
    }
    return mesh;
}

}  // namespace coppice::test
