// Automatic framing: the box is looked at from 16 sides, 20 degrees from above, and the side from
// which its corners span the largest rectangle is taken; then the eye moves back until every corner
// is within the pyramid of view, which is one division a corner and edge. Depends on the box alone.

#include "scenes/camera.h"

#include "coppice/base/error.h"
#include "coppice/geom/triangle_mesh.h"

#include "scenes/vector_math.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace coppice::render {

namespace {

constexpr double margin = 1.02;  // of the distance: nothing touches the edge of the image

/// An orthonormal frame to look along.
struct Sight {
    Vec3d forward;
    Vec3d right;
    Vec3d up;
};

Sight view_along(Vec3d direction, Vec3d up) {
    const Vec3d forward = normalized(direction);
    const Vec3d right = normalized(cross(forward, up));
    return {forward, right, cross(right, forward)};
}

Vec3d center_of(const Aabb& box) {
    return 0.5 * (to_double(box.lower) + to_double(box.upper));
}

std::array<Vec3d, 8> corners_of(const Aabb& box) {
    std::array<Vec3d, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] = to_double({(i & 1) != 0 ? box.upper.x : box.lower.x,
                                (i & 2) != 0 ? box.upper.y : box.lower.y,
                                (i & 4) != 0 ? box.upper.z : box.lower.z});
    }
    return corners;
}

/// The area of the rectangle that a box spans, seen along a view.
double spanned_area(const Aabb& box, const Sight& view) {
    double half_width = 0.0;
    double half_height = 0.0;
    for (const Vec3d corner : corners_of(box)) {
        const Vec3d offset = corner - center_of(box);
        half_width = std::max(half_width, std::abs(dot(offset, view.right)));
        half_height = std::max(half_height, std::abs(dot(offset, view.up)));
    }
    return half_width * half_height;
}

/// Most scenes stand on y = 0 or z = 0; what is flat in z lies on the latter.
Vec3f likely_up(const Aabb& box) {
    const bool is_flat_in_z = 2.0 * box.extent(Axis::z) < box.extent(Axis::y);
    return is_flat_in_z ? Vec3f{0.0F, 0.0F, 1.0F} : Vec3f{0.0F, 1.0F, 0.0F};
}

/// The same of a model that may say more: if it stands on z = 0 and not on y = 0, up is z.
Vec3f likely_up_of_model(const Aabb& box) {
    const auto stands_on = [&box](Axis axis) {
        return std::abs(double{box.lower[axis]}) <= 0.02 * box.extent(axis);
    };
    const bool stands_on_z = stands_on(Axis::z) && !stands_on(Axis::y);
    return stands_on_z ? Vec3f{0.0F, 0.0F, 1.0F} : likely_up(box);
}

/// The view that shows most of a box.
Sight best_view(const Aabb& box, Vec3d up) {
    constexpr int side_count = 16;
    constexpr double elevation = 20.0 * std::numbers::pi / 180.0;
    const Vec3d vertical = normalized(up);
    const Vec3d other = std::abs(vertical.x) < 0.9 ? Vec3d{1.0, 0.0, 0.0} : Vec3d{0.0, 1.0, 0.0};
    const Vec3d east = normalized(cross(other, vertical));
    const Vec3d north = cross(vertical, east);
    Sight best{};
    double best_area = -1.0;
    for (int side = 0; side < side_count; ++side) {
        const double angle = 2.0 * std::numbers::pi * (side + 0.25) / side_count;
        const Vec3d level = std::cos(angle) * east + std::sin(angle) * north;
        const Sight view =
            view_along(-std::cos(elevation) * level + -std::sin(elevation) * vertical, vertical);
        const double area = spanned_area(box, view);
        if (area > best_area * (1.0 + 1e-9)) {  // opposite sides show the same
            best = view;
            best_area = area;
        }
    }
    return best;
}

/// How far behind `target` the eye must be to see all points.
double framing_distance(std::span<const Vec3d> points, Vec3d target, const Sight& view,
                        double tan_half_height, double aspect) {
    double distance = 0.0;
    for (const Vec3d point : points) {
        const Vec3d offset = point - target;
        const double depth = dot(offset, view.forward);
        const double across = std::abs(dot(offset, view.right)) / (aspect * tan_half_height);
        const double along = std::abs(dot(offset, view.up)) / tan_half_height;
        distance = std::max({distance, across - depth, along - depth});
    }
    return distance > 0.0 ? margin * distance : 1.0;
}

/// The view from the opposite side if this one is from the back.
Sight from_front(const Sight& view, Vec3d vertical) {
    const Vec3d front =
        std::abs(vertical.y) >= std::abs(vertical.z) ? Vec3d{0.0, 0.0, 1.0} : Vec3d{0.0, -1.0, 0.0};
    const Vec3d level = view.forward - dot(view.forward, vertical) * vertical;
    const bool is_from_front = dot(level, front) <= 0.0;
    return is_from_front ? view : view_along(view.forward - 2.0 * level, vertical);
}

/// The middle of what points span along the axes of a view.
Vec3d center_in_view(std::span<const Vec3d> points, const Sight& view) {
    Vec3d center;
    for (const Vec3d axis : {view.forward, view.right, view.up}) {
        double lowest = std::numeric_limits<double>::infinity();
        double highest = -lowest;
        for (const Vec3d point : points) {
            lowest = std::min(lowest, dot(point, axis));
            highest = std::max(highest, dot(point, axis));
        }
        center = center + 0.5 * (lowest + highest) * axis;
    }
    return center;
}

double tan_half(double fov) {
    return std::tan(0.5 * fov * std::numbers::pi / 180.0);
}

/// A camera whose eye was chosen: throws Error(limit) if that is beyond the range of float.
const Camera& checked(const Camera& camera) {
    if (is_finite(camera.eye)) return camera;
    throw Error(ErrorCode::limit,
                "the scene is too large to be seen from outside in single precision; "
                "give --eye inside it, and --look-at");
}

}  // namespace

Vec3f in_few_digits(Vec3d point, double distance) {
    const double unit = std::pow(10.0, std::floor(std::log10(distance)) - 4.0);
    const auto round = [unit](double x) {
        const double multiple = std::round(x / unit) * unit;
        return std::isfinite(multiple) ? multiple + 0.0 : x;  // + 0.0: no -0
    };
    return to_float({round(point.x), round(point.y), round(point.z)});
}

Camera frame_box(const Aabb& box, const CameraWish& wish, double aspect) {
    const Aabb seen = box.is_empty() ? Aabb{{}, {}} : box;
    Camera camera;
    camera.fov = wish.fov.value_or(default_fov);
    camera.up = wish.up.value_or(likely_up(seen));
    const Vec3d target = wish.look_at ? to_double(*wish.look_at) : center_of(seen);
    camera.look_at = to_float(target);
    if (wish.eye) {
        camera.eye = *wish.eye;
        return camera;
    }
    const Sight view = best_view(seen, to_double(camera.up));
    const double distance =
        framing_distance(corners_of(seen), target, view, tan_half(camera.fov), aspect);
    camera.eye = to_float(target - distance * view.forward);
    return checked(camera);
}

Camera frame_points(std::span<const Vec3f> points, const CameraWish& wish, double aspect) {
    if (points.empty()) return frame_box({}, wish, aspect);
    const Aabb box = bounds_of(points);
    CameraWish known = wish;
    known.up = wish.up.value_or(likely_up_of_model(box));
    Camera camera = frame_box(box, known, aspect);
    if (wish.eye) return camera;
    std::vector<Vec3d> seen(points.size());
    std::transform(points.begin(), points.end(), seen.begin(), to_double);
    const Vec3d vertical = normalized(to_double(camera.up));
    const Sight view = from_front(best_view(box, vertical), vertical);
    const Vec3d target = wish.look_at ? to_double(*wish.look_at) : center_in_view(seen, view);
    const double distance = framing_distance(seen, target, view, tan_half(camera.fov), aspect);
    if (!wish.look_at) camera.look_at = in_few_digits(target, distance);
    camera.eye = in_few_digits(target - distance * view.forward, distance);
    return checked(camera);
}

Vec3f place_light(const Camera& camera, const Aabb& box) {
    const Vec3d sight = to_double(camera.look_at) - to_double(camera.eye);
    const Sight view = view_along(sight, to_double(camera.up));
    const double distance = length(sight);
    Vec3f light =
        to_float(to_double(camera.eye) + 0.4 * distance * view.up + 0.3 * distance * view.right);
    if (!box.contains(camera.eye)) return light;
    for (const Axis axis : all_axes) {
        // Not into a wall: a tenth of the room away from it.
        const auto inset = static_cast<float>(0.1 * box.extent(axis));
        light[axis] = std::clamp(light[axis], box.lower[axis] + inset, box.upper[axis] - inset);
    }
    return light;
}

CameraRays::CameraRays(const Camera& camera, int width, int height)
    : eye_(camera.eye), width_(width), height_(height) {
    if (width < 1 || height < 1) {
        throw Error(ErrorCode::invalid_argument, "the image has no pixels");
    }
    if (!(camera.fov > 0.0 && camera.fov < 180.0)) {
        throw Error(ErrorCode::invalid_argument, "the field of view is outside (0, 180)");
    }
    const Sight view =
        view_along(to_double(camera.look_at) - to_double(camera.eye), to_double(camera.up));
    if (view.right == Vec3d{}) {
        throw Error(
            ErrorCode::invalid_argument,
            "the camera looks along its up vector or at its own position; change --look-at or "
            "--up");
    }
    const double half_height = tan_half(camera.fov);
    forward_ = view.forward;
    up_ = half_height * view.up;
    right_ = half_height * width / height * view.right;
}

Ray CameraRays::at(double x, double y) const noexcept {
    const double across = 2.0 * x / width_ - 1.0;
    const double up = 1.0 - 2.0 * y / height_;
    return {eye_, to_float(normalized(forward_ + across * right_ + up * up_))};
}

std::string vector_text(Vec3f v) {
    return fmt::format("{},{},{}", v.x, v.y, v.z);
}

std::string camera_text(const Camera& camera) {
    return fmt::format("--eye={} --look-at={} --up={} --fov={}", vector_text(camera.eye),
                       vector_text(camera.look_at), vector_text(camera.up), camera.fov);
}

void to_json(nlohmann::json& json, const Camera& camera) {
    const auto array = [](Vec3f v) { return nlohmann::json::array({v.x, v.y, v.z}); };
    json = {{"eye", array(camera.eye)},
            {"look_at", array(camera.look_at)},
            {"up", array(camera.up)},
            {"fov", camera.fov}};
}

}  // namespace coppice::render
