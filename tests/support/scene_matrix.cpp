#include "support/scene_matrix.h"

#include "support/meshes.h"

#include <array>
#include <ostream>

namespace coppice::test {
namespace {

constexpr Triangle corner_triangle{Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{0, 1, 0.5F}};
constexpr Triangle far_triangle{Vec3f{5, 5, 5}, Vec3f{6, 5, 5.5F}, Vec3f{5, 6, 5}};

TriangleMesh huge_among_small(std::uint32_t count) {
    const TriangleMesh huge =
        make_triangle({Vec3f{-50, -40, -1}, Vec3f{50, -40, 0.5F}, Vec3f{0, 60, 2}});
    return joined(huge, make_soup(count, 0.03F, 5));
}

// Each axis gets a plane at 0 that triangles lie in, touch, end at and cross.
TriangleMesh around_zero() {
    TriangleMesh mesh;
    for (const Axis axis : all_axes) {
        for (const float offset : {-1.0F, 0.0F, 1.0F}) {
            Vec3f origin{-1, -1, -1};
            Vec3f u;
            Vec3f v;
            origin[axis] = offset;
            u[next_axis(axis)] = 0.5F;
            v[next_axis(next_axis(axis))] = 0.5F;
            mesh = joined(std::move(mesh), make_sheet(4, origin, u, v));
        }
    }
    return mesh;
}

constexpr std::array scenes{
    NamedScene{"empty", [] { return TriangleMesh{}; }},
    NamedScene{"one", [] { return make_triangle(corner_triangle); }},
    NamedScene{"two",
               [] { return joined(make_triangle(corner_triangle), make_triangle(far_triangle)); }},
    NamedScene{"identical_1000", [] { return repeated(make_triangle(corner_triangle), 1000); }},
    NamedScene{"coplanar_x0",
               [] {
                   return make_sheet(16, {0, -1, -1}, {0, 1, 0}, {0, 0, 1});
               }},
    NamedScene{"coplanar_z5",
               [] {
                   return make_sheet(16, {-3, 2, 5}, {0.3F, 0, 0}, {0, 1, 0});
               }},
    NamedScene{"coplanar_tilted",
               [] {
                   return make_sheet(16, {1, 2, 3}, {0.1F, 0.2F, 0.3F}, {-0.2F, 0.1F, 0.07F});
               }},
    NamedScene{"slivers_3", [] { return make_slivers(300, 1e-6F, 3); }},
    NamedScene{"needles_4", [] { return make_needles(150, 4); }},
    NamedScene{"huge_among_small_5", [] { return huge_among_small(2000); }},
    NamedScene{"boxes", [] { return make_boxes(4); }},
    NamedScene{"sphere", [] { return make_sphere(20, 30); }},
    NamedScene{"terrain_6", [] { return make_terrain(20, 6); }},
    NamedScene{"soup_7", [] { return make_soup(400, 0.1F, 7); }},
    NamedScene{"dense_soup_8", [] { return make_soup(150, 1.0F, 8); }},
    NamedScene{"tiny_9", [] { return scaled(make_soup(300, 0.1F, 9), 1e-30F); }},
    NamedScene{"denormal_10", [] { return scaled(make_soup(300, 0.1F, 10), 1e-41F); }},
    NamedScene{"huge_11", [] { return scaled(make_soup(300, 0.1F, 11), 1e30F); }},
    NamedScene{"utmost_12", [] { return scaled(make_soup(300, 0.1F, 12), 2.5e38F); }},
    NamedScene{"duplicates_13",
               [] {
                   return joined(
                       make_soup(60, 0.4F, 13),
                       repeated(make_triangle({Vec3f{0.2F, 0.2F, 0.3F}, Vec3f{0.6F, 0.3F, 0.3F},
                                               Vec3f{0.3F, 0.7F, 0.4F}}),
                                4096));
               }},
    NamedScene{"same_point", [] { return repeated(make_degenerate_points(1, 1), 300); }},
    NamedScene{"points_14", [] { return make_degenerate_points(300, 14); }},
    NamedScene{"collinear_x_15",
               [] {
                   return make_collinear(200, {1, 0, 0}, 15);
               }},
    NamedScene{"collinear_16",
               [] {
                   return make_collinear(200, {1, 2, -3}, 16);
               }},
    NamedScene{"fan", [] { return make_fan(300); }},
    NamedScene{"negative_zero_17", [] { return with_negative_zeros(around_zero(), 17); }},
};

}  // namespace

std::span<const NamedScene> scene_matrix() {
    return scenes;
}

void PrintTo(const NamedScene& scene, std::ostream* stream) {
    *stream << scene.name;
}

}  // namespace coppice::test
