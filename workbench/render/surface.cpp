// Shading points. The position comes from the hit's barycentric coordinates, not from the ray: its
// error is then a few roundings of the corners' coordinates, whatever the ray's length, and a bound
// on it follows from their size. Rays start that much off the surface: at any scale of the scene,
// and without a constant to be tuned. Coordinates have 24 bits; the bound is 8 units in the last
// place of the largest, which also covers the rounding of the start to floats.
// Source: [WachterBinder2019] (offsets by the size of coordinates), [Woop2013].

#include "render/surface.h"

#include "scenes/vector_math.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::render {

namespace {

double largest_coordinate(const Triangle& triangle) {
    float size = 0.0F;
    for (const Vec3f corner : triangle) {
        size = std::max({size, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
    }
    return size;
}

/// The mesh's normal at a corner; 0 if it has none.
Vec3d normal_at(TriangleMeshView mesh, const MeshAttributes& attributes, std::uint32_t triangle,
                std::size_t corner) {
    const std::uint32_t index = attributes.triangle_normals.empty()
                                    ? mesh.triangles()[triangle][corner]
                                    : attributes.triangle_normals[triangle][corner];
    if (index >= attributes.normals.size()) return {};
    const Vec3d normal = normalized(to_double(attributes.normals[index]));
    return std::isfinite(dot(normal, normal)) ? normal : Vec3d{};
}

/// The normal of the mesh between a triangle's corners; 0 if one of them has none.
Vec3d interpolated_normal(TriangleMeshView mesh, const MeshAttributes& attributes, const Hit& hit) {
    if (attributes.normals.empty()) return {};
    const std::array<double, 3> share{1.0 - hit.u - hit.v, hit.u, hit.v};
    Vec3d sum;
    for (std::size_t corner = 0; corner < share.size(); ++corner) {
        const Vec3d normal = normal_at(mesh, attributes, hit.prim, corner);
        if (normal == Vec3d{}) return {};
        sum = sum + share[corner] * normal;
    }
    return normalized(sum);
}

}  // namespace

TrianglePoint point_on(const Triangle& triangle, double u, double v) noexcept {
    const Vec3d a = to_double(triangle[0]);
    const Vec3d position = a + u * (to_double(triangle[1]) - a) + v * (to_double(triangle[2]) - a);
    return {position, 0x1.0p-21 * largest_coordinate(triangle)};
}

Vec3f Surface::start() const noexcept {
    return to_float(position + offset * facing);
}

const Material& material_of(const MeshAttributes& attributes, std::uint32_t triangle) noexcept {
    static const Material grey;
    if (attributes.triangle_materials.empty()) return grey;
    const std::uint32_t index = attributes.triangle_materials[triangle];
    return index == MeshAttributes::none ? grey : attributes.materials[index];
}

Surface surface_at(TriangleMeshView mesh, const MeshAttributes& attributes, const Ray& ray,
                   const Hit& hit) noexcept {
    const Triangle triangle = mesh.triangle(hit.prim);
    const Vec3d a = to_double(triangle[0]);
    const Vec3d direction = normalized(to_double(ray.direction));
    Vec3d facing = normalized(cross(to_double(triangle[1]) - a, to_double(triangle[2]) - a));
    if (facing == Vec3d{}) facing = -1.0 * direction;  // its area vanishes in rounding
    if (dot(facing, direction) > 0.0) facing = -1.0 * facing;
    Vec3d normal = interpolated_normal(mesh, attributes, hit);
    if (normal == Vec3d{}) normal = facing;
    if (dot(normal, facing) < 0.0) normal = -1.0 * normal;
    const TrianglePoint point = point_on(triangle, hit.u, hit.v);
    return {point.position, facing, normal, &material_of(attributes, hit.prim), point.offset};
}

}  // namespace coppice::render
