#include "support/rays.h"

#include "coppice/trace/brute_force.h"

#include <cmath>
#include <limits>

namespace coppice::test {
namespace {

// Zero with a random sign.
float any_zero(Random& random) {
    return random.below(2) == 0 ? 0.0F : -0.0F;
}

// The axis of a random face of a box, by area.
Axis face_axis(const Aabb& box, Random& random) {
    const auto area_across = [&](Axis axis) {
        return box.extent(next_axis(axis)) * box.extent(next_axis(next_axis(axis)));
    };
    double rest =
        random.unit() * (area_across(Axis::x) + area_across(Axis::y) + area_across(Axis::z));
    for (const Axis axis : {Axis::x, Axis::y}) {
        rest -= area_across(axis);
        if (rest < 0.0) return axis;
    }
    return Axis::z;
}

}  // namespace

std::string_view name_of(RayKind kind) noexcept {
    switch (kind) {
        case RayKind::line:
            return "line";
        case RayKind::between_points:
            return "between_points";
        case RayKind::axis_parallel:
            return "axis_parallel";
        case RayKind::at_vertex:
            return "at_vertex";
        case RayKind::at_edge:
            return "at_edge";
        case RayKind::at_triangle:
            return "at_triangle";
        case RayKind::in_split_plane:
            return "in_split_plane";
        case RayKind::from_split_plane:
            return "from_split_plane";
        case RayKind::limited:
            return "limited";
    }
    return "unknown";
}

Ray random_line_through(const Aabb& box, Random& random) {
    const Axis axis = face_axis(box, random);
    const bool from_upper = random.below(2) == 1;
    Ray ray{.origin = random.in_box(box)};
    ray.origin[axis] = from_upper ? box.upper[axis] : box.lower[axis];
    // Directions by the cosine to the face's normal.
    const double cosine = std::sqrt(random.unit());
    const double angle = 2.0 * std::numbers::pi * random.unit();
    const double sine = std::sqrt(1.0 - cosine * cosine);
    Vec3d direction;
    direction[axis] = from_upper ? -cosine : cosine;
    direction[next_axis(axis)] = sine * std::cos(angle);
    direction[next_axis(next_axis(axis))] = sine * std::sin(angle);
    ray.direction = to_float(direction);
    return ray;
}

Ray ray_through(Vec3f from, Vec3f to) noexcept {
    return {.origin = from, .direction = to - from};
}

RaySource::RaySource(const TriangleMesh& mesh, const KdTree& tree, std::uint64_t seed)
    : mesh_(mesh.view()), tree_(tree), box_(bounds_of(mesh.vertices)), random_(seed) {
    if (box_.is_empty()) box_ = {{0, 0, 0}, {1, 1, 1}};
}

Vec3f RaySource::vertex() {
    if (mesh_.size() == 0) return random_.in_box(box_);
    return mesh_.triangle(random_.below(mesh_.size()))[random_.below(3)];
}

Vec3f RaySource::point_of_triangle(bool on_edge) {
    if (mesh_.size() == 0) return random_.in_box(box_);
    const Triangle triangle = mesh_.triangle(random_.below(mesh_.size()));
    double u = random_.unit();
    double v = on_edge ? 0.0 : random_.unit();
    if (on_edge && random_.below(2) == 0) u = 0.5;
    if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
    }
    const std::uint32_t first = random_.below(3);
    const Vec3d a = to_double(triangle[first]);
    const Vec3d b = to_double(triangle[(first + 1) % 3]);
    const Vec3d c = to_double(triangle[(first + 2) % 3]);
    return to_float(a + u * (b - a) + v * (c - a));
}

Vec3f RaySource::origin() {
    Vec3f origin = random_.in_box(box_);
    if (random_.below(4) == 0) return origin;
    const double size = box_.extent(box_.longest_axis());
    const Vec3d away = random_.direction();
    for (const Axis axis : all_axes) {
        const double moved = origin[axis] + size * away[axis];
        constexpr double most = std::numeric_limits<float>::max();
        origin[axis] = static_cast<float>(std::clamp(moved, -most, most));
    }
    return origin;
}

SplitPlane RaySource::split_plane() {
    const auto nodes = tree_.nodes();
    for (int attempt = 0; attempt < 20; ++attempt) {
        const KdNode& node = nodes[random_.below(static_cast<std::uint32_t>(nodes.size()))];
        if (!node.is_leaf()) return node.plane();
    }
    const auto axis = static_cast<Axis>(random_.below(3));
    return {axis, random_.below(2) == 0 ? box_.lower[axis] : box_.upper[axis]};
}

Ray RaySource::axis_parallel() {
    const auto axis = static_cast<Axis>(random_.below(3));
    Ray ray{.origin = vertex()};
    for (const Axis other : all_axes) {
        ray.direction[other] = any_zero(random_);
    }
    const bool is_upward = random_.below(2) == 0;
    ray.direction[axis] = is_upward ? 1.0F : -1.0F;
    if (random_.below(3) == 0) return ray;  // from the vertex itself
    ray.origin[axis] = is_upward ? box_.lower[axis] : box_.upper[axis];
    if (random_.below(2) == 0) {
        const auto size = static_cast<float>(box_.extent(axis));
        ray.origin[axis] =
            std::clamp(ray.origin[axis] - ray.direction[axis] * size,
                       std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max());
    }
    return ray;
}

Ray RaySource::in_split_plane() {
    const SplitPlane plane = split_plane();
    Vec3f from = random_.below(2) == 0 ? origin() : vertex();
    Vec3f to = random_.below(2) == 0 ? point_of_triangle(true) : vertex();
    if (random_.below(3) == 0) {
        const Axis other = next_axis(plane.axis);  // axis-parallel within the plane
        from[other] = to[other];
    }
    from[plane.axis] = plane.position;
    to[plane.axis] = plane.position;
    Ray ray = ray_through(from, to);
    ray.direction[plane.axis] = any_zero(random_);
    return ray;
}

Ray RaySource::from_split_plane() {
    const SplitPlane plane = split_plane();
    Vec3f from = random_.in_box(box_);
    from[plane.axis] = plane.position;
    return ray_through(from, point_of_triangle(random_.below(2) == 0));
}

Ray RaySource::limited() {
    Ray ray = ray_through(origin(), point_of_triangle(false));
    const auto hit = brute_force_intersect(mesh_, ray);
    const float limit = hit ? hit->t : 1.0F;
    const std::array limits{limit, std::nextafter(limit, 0.0F),
                            std::nextafter(limit, Aabb::infinity)};
    switch (random_.below(4)) {
        case 0:
            ray.t_min = limits[random_.below(3)];
            break;
        case 1:
            ray.t_max = limits[random_.below(3)];
            break;
        case 2:
            ray.t_min = -limit;
            ray.t_max = limits[random_.below(3)];
            break;
        default:
            ray.t_min = ray.t_max = limit;
            break;
    }
    return ray;
}

Ray RaySource::next(RayKind kind) {
    switch (kind) {
        case RayKind::line:
            return random_line_through(box_, random_);
        case RayKind::between_points:
            return ray_through(origin(), random_.in_box(box_));
        case RayKind::axis_parallel:
            return axis_parallel();
        case RayKind::at_vertex:
            return ray_through(origin(), vertex());
        case RayKind::at_edge:
            return ray_through(origin(), point_of_triangle(true));
        case RayKind::at_triangle:
            return ray_through(origin(), point_of_triangle(false));
        case RayKind::in_split_plane:
            return in_split_plane();
        case RayKind::from_split_plane:
            return from_split_plane();
        case RayKind::limited:
            return limited();
    }
    return {};
}

}  // namespace coppice::test
