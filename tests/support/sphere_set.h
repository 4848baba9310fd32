#pragma once

#include "coppice/geom/aabb.h"

#include "support/random.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace coppice::test {

/// A user's own primitives: spheres, clipped a little better than by their boxes. Its size() is a
/// size_t, as of most containers.
class SphereSet {
public:
    struct Sphere {
        Vec3f center;
        float radius;
    };

    SphereSet(std::vector<Sphere> spheres)  // NOLINT(google-explicit-constructor)
        : spheres_(std::move(spheres)) {}

    [[nodiscard]] std::size_t size() const { return spheres_.size(); }

    [[nodiscard]] Aabb bounds(std::uint32_t id) const {
        const auto [center, radius] = spheres_[id];
        const Vec3f reach{radius, radius, radius};
        return {center - reach, center + reach};
    }

    /// Empty if the box misses the sphere, else the common part of both boxes.
    [[nodiscard]] Aabb clipped_bounds(std::uint32_t id, const Aabb& box) const {
        const auto [center, radius] = spheres_[id];
        double distance_squared = 0.0;
        for (const Axis axis : all_axes) {
            const double nearest = std::clamp(center[axis], box.lower[axis],
                                              std::max(box.lower[axis], box.upper[axis]));
            distance_squared += (center[axis] - nearest) * (center[axis] - nearest);
        }
        const double slightly_more = 1.000001 * radius;
        if (distance_squared > slightly_more * slightly_more) return {};
        const Aabb part = intersection(bounds(id), box);
        return part.is_empty() ? Aabb{} : part;
    }

private:
    std::vector<Sphere> spheres_;
};

[[nodiscard]] inline SphereSet make_spheres(std::uint32_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<SphereSet::Sphere> spheres;
    for (std::uint32_t i = 0; i < count; ++i) {
        spheres.push_back({random.in_box({{0, 0, 0}, {1, 1, 1}}), random.uniform(0.0F, 0.1F)});
    }
    return spheres;
}

/// The least that a user has to write: boxes, clipped by intersection.
class BoxSet {
public:
    explicit BoxSet(std::vector<Aabb> boxes) : boxes_(std::move(boxes)) {}

    [[nodiscard]] int size() const { return static_cast<int>(boxes_.size()); }

    [[nodiscard]] const Aabb& bounds(std::uint32_t id) const { return boxes_[id]; }

    [[nodiscard]] Aabb clipped_bounds(std::uint32_t id, const Aabb& box) const {
        return intersection(boxes_[id], box);
    }

private:
    std::vector<Aabb> boxes_;
};

[[nodiscard]] inline BoxSet make_box_set(std::uint32_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Aabb> boxes(count);
    for (Aabb& box : boxes) {
        box.grow(random.in_box({{0, 0, 0}, {1, 1, 1}}));
        box.grow(box.lower + 0.1F * random.in_box({{0, 0, 0}, {1, 1, 1}}));
    }
    return BoxSet(std::move(boxes));
}

}  // namespace coppice::test
