// Procedural scenes: what the tests and the demo use where no file is at hand. Each is a different
// kind of difficulty for a k-d tree:
// - `terrain`: one closed sheet of even triangles, the easy case;
// - `spheres`: surfaces of very uneven density over two huge triangles, which a small sample
// misses;
// - `soup`: no surface at all, and no empty space to cut off;
// - `city`: axis-aligned faces that lie in split planes, and streets of empty space.
// All randomness is random_unit(seed, counter), so that a scene is the same everywhere.

#include "scenes/procedural.h"

#include "coppice/base/error.h"
#include "coppice/base/named.h"
#include "coppice/base/rng.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace coppice::lab {

namespace {

/// A sequence of random numbers from (seed, 0), (seed, 1) ...
class Random {
public:
    explicit Random(std::uint64_t seed) noexcept : seed_(seed) {}

    /// The next number in [0, 1).
    double unit() noexcept { return random_unit(seed_, counter_++); }

    /// The next number in [low, high).
    double between(double low, double high) noexcept { return low + (high - low) * unit(); }

private:
    std::uint64_t seed_;
    std::uint64_t counter_ = 0;
};

std::uint32_t next_vertex(const TriangleMesh& mesh) {
    return static_cast<std::uint32_t>(mesh.vertices.size());
}

/// Two triangles in the plane z = 0, from (0, 0) to (size, size).
void add_ground(TriangleMesh& mesh, float size) {
    const std::uint32_t v = next_vertex(mesh);
    mesh.vertices.insert(mesh.vertices.end(),
                         {{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}});
    mesh.triangles.insert(mesh.triangles.end(), {{v, v + 1, v + 2}, {v, v + 2, v + 3}});
}

double smooth_step(double t) {
    return t * t * (3.0 - 2.0 * t);
}

/// Value noise: random heights on the integer lattice, smoothly interpolated; in [0, 1).
double lattice_noise(double x, double y, std::uint64_t seed) {
    const double x0 = std::floor(x);
    const double y0 = std::floor(y);
    const auto height = [&](double dx, double dy) {
        const auto column = static_cast<std::uint64_t>(x0 + dx);
        const auto row = static_cast<std::uint64_t>(y0 + dy);
        return random_unit(seed, column << 32 | row);
    };
    const double u = smooth_step(x - x0);
    const double v = smooth_step(y - y0);
    return std::lerp(std::lerp(height(0, 0), height(1, 0), u),
                     std::lerp(height(0, 1), height(1, 1), u), v);
}

/// Ten octaves of noise, each twice as fine and half as high; (x, y) in [0, 1].
double terrain_height(double x, double y, std::uint64_t seed) {
    double height = 0.0;
    double frequency = 3.0;
    double amplitude = 0.25;
    for (std::uint64_t octave = 0; octave < 10; ++octave) {
        height += amplitude * lattice_noise(x * frequency, y * frequency, seed + octave);
        frequency *= 2.0;
        amplitude *= 0.5;
    }
    return height;
}

TriangleMesh make_terrain(std::uint32_t triangle_count, std::uint64_t seed) {
    const auto columns =
        std::max(1U, static_cast<std::uint32_t>(std::lround(std::sqrt(triangle_count / 2.0))));
    const std::uint32_t rows = std::max(1U, (triangle_count + columns) / (2 * columns));
    TriangleMesh mesh;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        for (std::uint32_t column = 0; column <= columns; ++column) {
            const double x = static_cast<double>(column) / columns;
            const double y = static_cast<double>(row) / rows;
            mesh.vertices.push_back(to_float({x, y, terrain_height(x, y, seed)}));
        }
    }
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t v = row * (columns + 1) + column;
            const std::uint32_t above = v + columns + 1;
            mesh.triangles.push_back({v, v + 1, above + 1});
            mesh.triangles.push_back({v, above + 1, above});
        }
    }
    return mesh;
}

/// How a sphere is cut into triangles: 2 * meridians * (bands - 1) of them.
struct Tessellation {
    std::uint32_t meridians;
    std::uint32_t bands;

    [[nodiscard]] std::uint32_t triangle_count() const { return 2 * meridians * (bands - 1); }
};

/// The closed sphere with about `budget` triangles.
Tessellation tessellation_for(double budget) {
    const auto bands =
        std::max(3U, static_cast<std::uint32_t>(std::lround(0.5 * std::sqrt(budget))));
    const double meridians = std::round(budget / (2.0 * (bands - 1)));
    return {static_cast<std::uint32_t>(std::max(3.0, meridians)), bands};
}

/// A sphere of two poles and `bands - 1` rings, without a seam.
void add_sphere(TriangleMesh& mesh, Vec3d centre, double radius, Tessellation parts) {
    const std::uint32_t south = next_vertex(mesh);
    const auto n = parts.meridians;
    mesh.vertices.push_back(to_float(centre - Vec3d{0, 0, radius}));
    for (std::uint32_t ring = 1; ring < parts.bands; ++ring) {
        const double latitude = std::numbers::pi * (static_cast<double>(ring) / parts.bands - 0.5);
        for (std::uint32_t i = 0; i < n; ++i) {
            const double longitude = 2.0 * std::numbers::pi * i / n;
            const Vec3d direction{std::cos(latitude) * std::cos(longitude),
                                  std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
            mesh.vertices.push_back(to_float(centre + radius * direction));
        }
    }
    const std::uint32_t north = next_vertex(mesh);
    mesh.vertices.push_back(to_float(centre + Vec3d{0, 0, radius}));
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t next = (i + 1) % n;
        mesh.triangles.push_back({south, south + 1 + next, south + 1 + i});
        for (std::uint32_t ring = 0; ring + 2 < parts.bands; ++ring) {
            const std::uint32_t lower = south + 1 + ring * n;
            const std::uint32_t upper = lower + n;
            mesh.triangles.push_back({lower + i, lower + next, upper + next});
            mesh.triangles.push_back({lower + i, upper + next, upper + i});
        }
        mesh.triangles.push_back({north, north - n + i, north - n + next});
    }
}

TriangleMesh make_spheres(std::uint32_t triangle_count, std::uint64_t seed) {
    constexpr double ground_size = 100.0;
    constexpr double mean_sphere_triangles = 500.0;
    const double budget = std::max(12.0, triangle_count - 2.0);
    const double sphere_count = std::max(1.0, std::floor(budget / mean_sphere_triangles));
    TriangleMesh mesh;
    add_ground(mesh, ground_size);
    Random random(seed);
    double spent = 0.0;
    for (double i = 1.0; i <= sphere_count; i += 1.0) {
        // Radii from 0.02 to 6, evenly spread over the orders of magnitude.
        const double radius = 0.02 * std::pow(300.0, random.unit());
        const Vec3d centre{random.between(0.0, ground_size), random.between(0.0, ground_size),
                           radius + random.between(0.0, 3.0)};
        // What rounding spent too much or too little, the next spheres make up for.
        const Tessellation parts = tessellation_for(budget * i / sphere_count - spent);
        add_sphere(mesh, centre, radius, parts);
        spent += parts.triangle_count();
    }
    return mesh;
}

TriangleMesh make_soup(std::uint32_t triangle_count, std::uint64_t seed) {
    const double size = 2.0 / std::cbrt(static_cast<double>(triangle_count));
    TriangleMesh mesh;
    Random random(seed);
    for (std::uint32_t i = 0; i < triangle_count; ++i) {
        const std::uint32_t v = next_vertex(mesh);
        const Vec3d centre{random.unit(), random.unit(), random.unit()};
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3d offset{random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5};
            mesh.vertices.push_back(to_float(centre + size * offset));
        }
        mesh.triangles.push_back({v, v + 1, v + 2});
    }
    return mesh;
}

struct Box {
    Vec3d lower;
    Vec3d upper;
};

/// Twelve triangles around a box; corner i has the upper x, y, z where bit 0, 1, 2 of i is set.
void add_box(TriangleMesh& mesh, const Box& box) {
    constexpr std::array<TriangleIndices, 12> faces{{{0, 2, 3},
                                                     {0, 3, 1},
                                                     {4, 5, 7},
                                                     {4, 7, 6},
                                                     {0, 1, 5},
                                                     {0, 5, 4},
                                                     {2, 6, 7},
                                                     {2, 7, 3},
                                                     {0, 4, 6},
                                                     {0, 6, 2},
                                                     {1, 3, 7},
                                                     {1, 7, 5}}};
    const std::uint32_t v = next_vertex(mesh);
    for (unsigned corner = 0; corner < 8; ++corner) {
        mesh.vertices.push_back(to_float({(corner & 1U) != 0 ? box.upper.x : box.lower.x,
                                          (corner & 2U) != 0 ? box.upper.y : box.lower.y,
                                          (corner & 4U) != 0 ? box.upper.z : box.lower.z}));
    }
    for (const TriangleIndices& face : faces) {
        mesh.triangles.push_back({v + face[0], v + face[1], v + face[2]});
    }
}

/// A box that stands on the roof of another, smaller by a random factor.
Box make_roof_box(const Box& house, Random& random) {
    const Vec3d size = house.upper - house.lower;
    const double share = random.between(0.1, 0.5);
    const double x = house.lower.x + random.between(0.0, 1.0 - share) * size.x;
    const double y = house.lower.y + random.between(0.0, 1.0 - share) * size.y;
    const double height = share * std::min(size.x, size.y);
    return {{x, y, house.upper.z},
            {x + share * size.x, y + share * size.y, house.upper.z + height}};
}

TriangleMesh make_city(std::uint32_t triangle_count, std::uint64_t seed) {
    constexpr double ground_size = 100.0;
    constexpr std::uint32_t boxes_per_lot = 3;  // a house and what stands on it
    const std::uint32_t box_count = triangle_count <= 20 ? 1 : (triangle_count + 4) / 12;
    const std::uint32_t lot_count = (box_count + boxes_per_lot - 1) / boxes_per_lot;
    const auto lots_per_side = static_cast<std::uint32_t>(std::ceil(std::sqrt(lot_count)));
    const double lot_size = ground_size / lots_per_side;
    TriangleMesh mesh;
    add_ground(mesh, static_cast<float>(ground_size));
    Random random(seed);
    Box house{};
    for (std::uint32_t i = 0; i < box_count; ++i) {
        if (i % boxes_per_lot != 0) {
            add_box(mesh, make_roof_box(house, random));
            continue;
        }
        const std::uint32_t lot = i / boxes_per_lot;
        const std::uint32_t column = lot % lots_per_side;
        const std::uint32_t row = lot / lots_per_side;
        const double x = column * lot_size;
        const double y = row * lot_size;
        const double width = random.between(0.3, 0.9) * lot_size;
        const double depth = random.between(0.3, 0.9) * lot_size;
        // Few houses are high: heights are distributed exponentially.
        const double height = lot_size * (0.2 - std::log(1.0 - random.unit()));
        house = {{x, y, 0.0}, {x + width, y + depth, height}};
        add_box(mesh, house);
    }
    return mesh;
}

constexpr std::array<ProceduralScene, 4> scenes{{
    {"terrain", "a fractal height field: one sheet of even triangles", &make_terrain},
    {"spheres", "tessellated spheres of very uneven sizes over a ground of two huge triangles",
     &make_spheres},
    {"soup", "small triangles scattered at random in a cube", &make_soup},
    {"city", "axis-aligned boxes of varied size on a ground of two huge triangles", &make_city},
}};

}  // namespace

std::span<const ProceduralScene> procedural_registry() {
    return scenes;
}

TriangleMesh make_procedural(std::string_view name, std::uint32_t triangle_count,
                             std::uint64_t seed) {
    const ProceduralScene& scene = find_named(procedural_registry(), name, "procedural scene");
    if (triangle_count < 1 || triangle_count > max_procedural_triangles) {
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("the number of triangles {} is not in [1, {}]", triangle_count,
                                max_procedural_triangles));
    }
    return scene.make(triangle_count, seed);
}

}  // namespace coppice::lab
