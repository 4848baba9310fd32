// Primitives of one's own: spheres. What a tree needs to know of them is their boxes; what a ray
// needs is the test in a leaf.
#include <coppice/coppice.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

namespace {

struct Sphere {
    coppice::Vec3f center;
    float radius;
};

// A PrimitiveSet: a size, a box for each, and the box of its part inside another box.
class SphereSet {
public:
    explicit SphereSet(std::vector<Sphere> spheres) : spheres_(std::move(spheres)) {}

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(spheres_.size()); }

    [[nodiscard]] coppice::Aabb bounds(std::uint32_t id) const {
        const auto& [center, radius] = spheres_[id];
        const coppice::Vec3f reach{radius, radius, radius};
        return {center - reach, center + reach};
    }

    [[nodiscard]] coppice::Aabb clipped_bounds(std::uint32_t id, const coppice::Aabb& box) const {
        return coppice::intersection(bounds(id), box);
    }

    // The distance to where a ray of unit direction enters or leaves a sphere, if it does.
    [[nodiscard]] std::optional<float> intersect(std::uint32_t id, const coppice::Ray& ray) const {
        const auto& [center, radius] = spheres_[id];
        const coppice::Vec3f to_center = center - ray.origin;
        const float middle = coppice::dot(to_center, ray.direction);
        const float half_squared =
            radius * radius - (coppice::dot(to_center, to_center) - middle * middle);
        if (half_squared < 0.0F) return std::nullopt;
        for (const float t : {middle - std::sqrt(half_squared), middle + std::sqrt(half_squared)}) {
            if (t >= ray.t_min && t <= ray.t_max) return t;
        }
        return std::nullopt;
    }

private:
    std::vector<Sphere> spheres_;
};

static_assert(coppice::PrimitiveSet<SphereSet>);

// Follows a ray down the tree, the nearer child first; `ray.t_max` is the closest hit so far.
void trace(const coppice::KdTree& tree, const coppice::KdNode& node, const SphereSet& spheres,
           coppice::Ray& ray, coppice::Hit& closest) {
    if (node.is_leaf()) {
        for (const std::uint32_t id : tree.references(node)) {
            if (const auto t = spheres.intersect(id, ray)) {
                closest = {.t = *t, .prim = id};
                ray.t_max = *t;
            }
        }
        return;
    }
    const float direction = ray.direction[node.axis()];
    const float offset = node.position() - ray.origin[node.axis()];
    const bool is_below_first = offset != 0.0F ? offset > 0.0F : direction < 0.0F;
    const float t_plane = offset / direction;  // infinite, or no number, if parallel
    const auto& nodes = tree.nodes();
    const coppice::KdNode& near = nodes[is_below_first ? node.lower_child() : node.upper_child()];
    const coppice::KdNode& far = nodes[is_below_first ? node.upper_child() : node.lower_child()];
    trace(tree, near, spheres, ray, closest);
    if (!(t_plane < 0.0F) && !(t_plane > ray.t_max)) trace(tree, far, spheres, ray, closest);
}

}  // namespace

int main() {
    std::vector<Sphere> grid(1000, Sphere{{}, 0.25F});
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        const std::uint32_t row = i / 10;
        const std::uint32_t layer = i / 100;
        grid[i].center = {static_cast<float>(i % 10), static_cast<float>(row % 10),
                          static_cast<float>(layer)};
    }
    const SphereSet spheres(std::move(grid));

    // Built from a tenth of the spheres, emptied, refilled with all of them, grown on.
    const auto [tree, report] = coppice::build_kd_tree(spheres, {.sample = {.rate = 0.1}});
    std::printf("%u of %u spheres sampled, %zu nodes\n", report.sample_count,
                report.primitive_count, tree.nodes().size());

    coppice::Ray ray{.origin = {4.0F, 5.0F, -10.0F}, .direction = {0, 0, 1}};
    coppice::Hit hit;
    trace(tree, tree.root(), spheres, ray, hit);
    std::printf("sphere %u at t = %g\n", hit.prim, hit.t);
}
