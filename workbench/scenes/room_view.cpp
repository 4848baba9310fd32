// Finds a camera position inside a room, which shows only its walls from outside. Candidates are
// the points of a grid near half the height of the box that have a surface in all six axis
// directions. Rays to points spread evenly over the surface count what each candidate sees; the
// best one sees most of them within one view. Inside a statue there is less to see than from
// outside, so it is not taken for a room. Cost: 75 candidates times 512 rays.

#include "scenes/room_view.h"

#include "scenes/surface_points.h"
#include "scenes/vector_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace coppice::lab {

namespace {

constexpr std::size_t target_count = 512;
constexpr double room_fov = 60.0;
constexpr double cosine_of_view = 0.77;  // 40 degrees to either side: well within such a camera
constexpr double least_gain = 1.5;       // how much more a room shows inside than outside

std::vector<Vec3d> targets_seen(const TracedTree& tracer, std::span<const Vec3f> targets,
                                Vec3f eye) {
    std::vector<Vec3d> seen;
    for (const Vec3f target : targets) {
        const Ray ray{.origin = eye, .direction = target - eye, .t_max = 0.999F};
        if (!tracer.occluded(ray)) seen.push_back(to_double(target));
    }
    return seen;
}

bool is_enclosed(const TracedTree& tracer, Vec3f eye) {
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        for (const float sign : {-1.0F, 1.0F}) {
            Ray ray{.origin = eye};
            ray.direction = {0.0F, 0.0F, 0.0F};
            ray.direction[axis] = sign;
            if (!tracer.occluded(ray)) return false;
        }
    }
    return true;
}

Vec3d centroid_of(const std::vector<Vec3d>& points) {
    Vec3d sum{0.0, 0.0, 0.0};
    for (const Vec3d point : points) {
        sum = sum + point;
    }
    return (1.0 / static_cast<double>(points.size())) * sum;
}

/// How many points a camera at `eye` has in view that looks at `center`.
std::size_t count_in_view(const std::vector<Vec3d>& points, Vec3d eye, Vec3d center) {
    const Vec3d forward = center - eye;
    return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](Vec3d point) {
        const Vec3d toward = point - eye;
        return dot(toward, forward) >
               cosine_of_view * render::length(toward) * render::length(forward);
    }));
}

/// The places to try: level with the middle of the box, or a little above or below.
std::vector<Vec3f> places_in(const Aabb& box, Axis upward) {
    constexpr std::array<double, 5> across{0.1, 0.3, 0.5, 0.7, 0.9};
    constexpr std::array<double, 3> along_up{0.4, 0.5, 0.6};
    const auto shares = [&](Axis axis) {
        return axis == upward ? std::span<const double>(along_up) : std::span<const double>(across);
    };
    const auto at = [&](Axis axis, double share) {
        return static_cast<float>(double{box.lower[axis]} + share * box.extent(axis));
    };
    std::vector<Vec3f> places;
    for (const double x : shares(Axis::x)) {
        for (const double y : shares(Axis::y)) {
            for (const double z : shares(Axis::z)) {
                places.push_back({at(Axis::x, x), at(Axis::y, y), at(Axis::z, z)});
            }
        }
    }
    return places;
}

Axis main_axis(Vec3f direction) {
    Axis main = Axis::x;
    for (const Axis axis : {Axis::y, Axis::z}) {
        if (std::abs(direction[axis]) > std::abs(direction[main])) main = axis;
    }
    return main;
}

bool is_free(const render::CameraWish& wish) {
    return !wish.eye && !wish.look_at;
}

/// A camera inside a mesh that is a room, nothing for any other mesh.
std::optional<render::Camera> view_of_room(TriangleMeshView mesh, const TracedTree& tracer,
                                           const render::Camera& outside,
                                           std::optional<double> fov) {
    const std::vector<Vec3f> targets = surface_points(mesh, target_count).positions;
    const auto outside_count =
        static_cast<double>(targets_seen(tracer, targets, outside.eye).size());
    std::optional<render::Camera> best;
    std::size_t best_count = 0;
    for (const Vec3f eye : places_in(bounds_of(mesh.vertices()), main_axis(outside.up))) {
        if (!is_enclosed(tracer, eye)) continue;
        const std::vector<Vec3d> seen = targets_seen(tracer, targets, eye);
        if (seen.empty() || static_cast<double>(seen.size()) < least_gain * outside_count) continue;
        const Vec3d center = centroid_of(seen);
        const std::size_t count = count_in_view(seen, to_double(eye), center);
        if (count <= best_count) continue;
        best_count = count;
        const double distance = render::length(center - to_double(eye));
        best = render::Camera{render::in_few_digits(to_double(eye), distance),
                              render::in_few_digits(center, distance), outside.up,
                              fov.value_or(room_fov)};
    }
    return best;
}

}  // namespace

ChosenCamera choose_camera(TriangleMeshView mesh, const TracedTree& tracer,
                           const render::CameraWish& wish, double aspect) {
    const render::Camera outside = render::frame_points(mesh.vertices(), wish, aspect);
    const auto inside =
        is_free(wish) ? view_of_room(mesh, tracer, outside, wish.fov) : std::nullopt;
    return {inside.value_or(outside), inside.has_value()};
}

render::Camera choose_ray_camera(TriangleMeshView mesh, const render::CameraWish& wish,
                                 int threads) {
    const render::Camera outside = render::frame_box(bounds_of(mesh.vertices()), wish, 1.0);
    if (!is_free(wish) || mesh.size() == 0) return outside;
    const TracedTree tracer = build_picture_tree(mesh, threads);
    return view_of_room(mesh, tracer, outside, wish.fov).value_or(outside);
}

}  // namespace coppice::lab
