#pragma once

#include "coppice/geom/triangle_mesh.h"

#include "support/random.h"

#include <cmath>
#include <vector>

namespace coppice::test {

/// Points to ask from: on corners, on and beside edges and faces, anywhere in the box, far away.
[[nodiscard]] inline std::vector<Vec3f> make_query_points(TriangleMeshView mesh, int rounds,
                                                          std::uint64_t seed) {
    std::vector<Vec3f> points{{0, 0, 0}, {-0.0F, 1, 3e38F}};
    if (mesh.size() == 0) return points;
    Random random(seed);
    const Aabb box = bounds_of(mesh.vertices());
    const double size = box.extent(box.longest_axis());
    for (int i = 0; i < rounds; ++i) {
        const Triangle t = mesh.triangle(random.below(mesh.size()));
        const Vec3d middle = 0.5 * (to_double(t[0]) + to_double(t[1]));
        const Vec3d inside = (1.0 / 3.0) * (2.0 * middle + to_double(t[2]));
        const Vec3d beside = middle + std::exp2(-2.0 * i) * size * random.direction();
        const Vec3d away = middle + std::min(1e6 * size, 1e37) * random.direction();
        for (const Vec3d& at : {to_double(t[0]), middle, inside, beside, away}) {
            points.push_back(to_float(at));
        }
        points.push_back(random.in_box(box));
    }
    return points;
}

}  // namespace coppice::test
