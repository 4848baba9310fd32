// Rays through what traversals treat as special cases: vertices, edges, the planes of faces, which
// are also where builders put their planes, and zeros in the direction. Everything is computed in
// double from (seed, i) and rounded to float once.

#include "scenes/hard_rays.h"

#include "coppice/base/rng.h"

#include "scenes/vector_math.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace coppice::lab {

namespace {

/// The random numbers of one ray.
class Draw {
public:
    Draw(std::uint64_t seed, std::size_t ray) : seed_(seed), counter_(std::uint64_t{ray} << 8) {}

    double unit() { return random_unit(seed_, counter_++); }

    std::uint32_t below(std::uint32_t count) {
        return static_cast<std::uint32_t>(unit() * static_cast<double>(count));
    }

    float zero() { return below(2) == 0 ? 0.0F : -0.0F; }

private:
    std::uint64_t seed_;
    std::uint64_t counter_;
};

double diagonal_of(const Aabb& box) {
    return render::length({box.extent(Axis::x), box.extent(Axis::y), box.extent(Axis::z)});
}

/// The nearest point that is finite in float.
Vec3f finite(Vec3d p) {
    constexpr double most = std::numeric_limits<float>::max();
    for (const Axis axis : all_axes) {
        p[axis] = std::clamp(p[axis], -most, most);
    }
    return to_float(p);
}

/// An axis with the probability that the box's faces across it are of its surface.
Axis face_axis(const Aabb& box, Draw& draw) {
    const auto area_across = [&](Axis axis) {
        return box.extent(next_axis(axis)) * box.extent(next_axis(next_axis(axis)));
    };
    double rest = draw.unit() * box.surface_area() / 2.0;
    for (const Axis axis : {Axis::x, Axis::y}) {
        rest -= area_across(axis);
        if (rest < 0.0) return axis;
    }
    return Axis::z;
}

Ray random_ray(const Aabb& box, Draw draw) {
    const Axis axis = face_axis(box, draw);
    const bool from_above = draw.below(2) == 1;
    Vec3d entry;
    for (const Axis each : all_axes) {
        entry[each] = box.lower[each] + draw.unit() * box.extent(each);
    }
    entry[axis] = from_above ? box.upper[axis] : box.lower[axis];
    const double cosine = std::sqrt(draw.unit());  // to the face's normal
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double angle = 2.0 * std::numbers::pi * draw.unit();
    Vec3d direction;
    direction[axis] = from_above ? -cosine : cosine;
    direction[next_axis(axis)] = sine * std::cos(angle);
    direction[next_axis(next_axis(axis))] = sine * std::sin(angle);
    return {finite(entry - 0.25 * diagonal_of(box) * direction), to_float(direction)};
}

Ray axis_ray(TriangleMeshView mesh, const Aabb& box, Draw draw) {
    const Vec3f vertex = mesh.triangle(draw.below(mesh.size()))[draw.below(3)];
    const auto axis = static_cast<Axis>(draw.below(3));
    const bool is_up = draw.below(2) == 1;
    const double margin = 0.25 * diagonal_of(box);
    Vec3d origin = to_double(vertex);
    origin[axis] = is_up ? box.lower[axis] - margin : box.upper[axis] + margin;
    Ray ray{finite(origin), {draw.zero(), draw.zero(), draw.zero()}};
    ray.direction[axis] = is_up ? 1.0F : -1.0F;
    return ray;
}

Vec3d point_of(const Triangle& triangle, Draw& draw) {
    double u = draw.unit();
    double v = draw.unit();
    if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
    }
    const Vec3d a = to_double(triangle[0]);
    return a + u * (to_double(triangle[1]) - a) + v * (to_double(triangle[2]) - a);
}

Ray grazing_ray(TriangleMeshView mesh, double diagonal, Draw draw) {
    for (int attempt = 0; attempt < 16; ++attempt) {
        const Triangle triangle = mesh.triangle(draw.below(mesh.size()));
        const Vec3d from = point_of(triangle, draw);
        const Vec3d along = point_of(triangle, draw) - from;
        const double size = render::length(along);
        if (!(size > 0.0)) continue;  // a triangle that is a point
        const Vec3d direction = (1.0 / size) * along;
        // From a triangle's size away to a scene's, each scale as often.
        const double away = size * std::pow(std::max(1.0, diagonal / size), draw.unit());
        const Ray ray{finite(from - away * direction), to_float(direction)};
        if (is_traceable(ray)) return ray;
    }
    return {to_float(to_double(mesh.triangle(0)[0])), {1.0F, 0.0F, 0.0F}};
}

template <typename MakeRay>
std::vector<Ray> make_rays(TriangleMeshView mesh, std::size_t count, std::uint64_t seed,
                           MakeRay&& make) {
    std::vector<Ray> rays;
    if (mesh.size() == 0) return rays;
    rays.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        rays.push_back(make(Draw(seed, i)));
    }
    return rays;
}

}  // namespace

std::vector<Ray> random_rays(TriangleMeshView mesh, std::size_t count, std::uint64_t seed) {
    const Aabb box = bounds_of(mesh.vertices());
    return make_rays(mesh, count, seed, [&](Draw draw) { return random_ray(box, draw); });
}

std::vector<Ray> axis_rays(TriangleMeshView mesh, std::size_t count, std::uint64_t seed) {
    const Aabb box = bounds_of(mesh.vertices());
    return make_rays(mesh, count, seed, [&](Draw draw) { return axis_ray(mesh, box, draw); });
}

std::vector<Ray> grazing_rays(TriangleMeshView mesh, std::size_t count, std::uint64_t seed) {
    const double diagonal = diagonal_of(bounds_of(mesh.vertices()));
    return make_rays(mesh, count, seed,
                     [&](Draw draw) { return grazing_ray(mesh, diagonal, draw); });
}

}  // namespace coppice::lab
