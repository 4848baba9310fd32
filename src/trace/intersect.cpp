// Ordered traversal of the k-d tree: at each inner node the ray's interval is cut at the plane, the
// nearer child is visited first and the other waits on a stack. Plane distances are computed in
// double from float input, so they are off by a few units in the last place of a double; intervals
// are widened by far more than that, hence no leaf that the ray touches is passed over. A ray
// parallel to a plane has no distance to it: it visits one side, or both if it lies in the plane.
// Source: [Pharr2016] sec. 4.4.3 (ordered traversal with a stack).

#include "coppice/trace/intersect.h"

#include "coppice/geom/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice {
namespace {

constexpr int max_stack = KdTree::max_depth + 1;  // one entry a level at most, and the root

struct Interval {
    double enter;
    double exit;
};

struct Entry {
    std::uint32_t node;
    Interval interval;
};

// Distances are off by at most 3 * 2^-53 of themselves.
Interval widened(double distance) noexcept {
    const double slack = 0x1.0p-40 * std::abs(distance);
    return {distance - slack, distance + slack};
}

// How far a distance may be from the float it is rounded to.
double rounding_of(float t) noexcept {
    return 0x1.0p-22 * std::abs(static_cast<double>(t)) + 0x1.0p-149;
}

// The part of the ray inside a box, widened; empty (enter > exit) if it misses. Hits count by their
// rounded t, so those a little outside of t_min and t_max may belong to the ray.
Interval clip_to_box(const Ray& ray, const Aabb& box) noexcept {
    Interval inside{ray.t_min - rounding_of(ray.t_min), ray.t_max + rounding_of(ray.t_max)};
    for (const Axis axis : all_axes) {
        const double origin = ray.origin[axis];
        const double direction = ray.direction[axis];
        if (direction == 0.0) {
            if (origin < box.lower[axis] || origin > box.upper[axis]) return {1.0, 0.0};
            continue;
        }
        const Interval lower = widened((box.lower[axis] - origin) / direction);
        const Interval upper = widened((box.upper[axis] - origin) / direction);
        inside.enter = std::max(inside.enter, std::min(lower.enter, upper.enter));
        inside.exit = std::min(inside.exit, std::max(lower.exit, upper.exit));
    }
    return inside;
}

// The stack of nodes still to visit. Never overflows: at most one entry a level is pushed.
class Stack {
public:
    void push(std::uint32_t node, Interval interval) noexcept {
        if (interval.enter <= interval.exit) entries_[size_++] = {node, interval};
    }

    [[nodiscard]] bool is_empty() const noexcept { return size_ == 0; }

    Entry pop() noexcept { return entries_[--size_]; }

private:
    std::array<Entry, max_stack> entries_;
    std::size_t size_ = 0;
};

// Puts the children of an inner node that the ray meets on the stack, the nearer one on top.
void push_children(Stack& stack, const KdNode& node, const Ray& ray, Interval inside) noexcept {
    const double direction = ray.direction[node.axis()];
    const double to_plane = static_cast<double>(node.position()) - ray.origin[node.axis()];
    if (direction == 0.0) {
        if (to_plane <= 0.0) stack.push(node.upper_child(), inside);
        if (to_plane >= 0.0) stack.push(node.lower_child(), inside);
        return;
    }
    const Interval plane = widened(to_plane / direction);
    const std::uint32_t near = direction > 0.0 ? node.lower_child() : node.upper_child();
    const std::uint32_t far = direction > 0.0 ? node.upper_child() : node.lower_child();
    stack.push(far, {std::max(inside.enter, plane.enter), inside.exit});
    stack.push(near, {inside.enter, std::min(inside.exit, plane.exit)});
}

// Tests the triangles of a leaf; true if the search is over.
template <bool any_hit>
bool test_leaf(std::span<const std::uint32_t> ids, TriangleMeshView mesh, const Ray& ray,
               std::optional<Hit>& closest) noexcept {
    for (const std::uint32_t id : ids) {
        auto hit = intersect_triangle(ray, mesh.triangle(id));
        if (!hit) continue;
        hit->prim = id;
        const bool is_closer =
            !closest || hit->t < closest->t || (hit->t == closest->t && id < closest->prim);
        if (is_closer) closest = hit;
        if (any_hit) return true;
    }
    return false;
}

// Closest and any hit in one: the latter stops at the first.
template <bool any_hit>
std::optional<Hit> trace(const KdTree& tree, TriangleMeshView mesh, const Ray& ray) noexcept {
    std::optional<Hit> closest;
    if (!is_traceable(ray)) return closest;
    Stack stack;
    stack.push(0, clip_to_box(ray, tree.bounds()));
    while (!stack.is_empty()) {
        const auto [index, inside] = stack.pop();
        // Hits whose t is rounded to the same may lie a little behind.
        if (closest && inside.enter > closest->t + rounding_of(closest->t)) continue;
        const KdNode& node = tree.nodes()[index];
        if (!node.is_leaf()) {
            push_children(stack, node, ray, inside);
        } else if (test_leaf<any_hit>(tree.references(node), mesh, ray, closest)) {
            break;
        }
    }
    return closest;
}

}  // namespace

std::optional<Hit> intersect(const KdTree& tree, TriangleMeshView mesh, const Ray& ray) noexcept {
    return trace<false>(tree, mesh, ray);
}

bool occluded(const KdTree& tree, TriangleMeshView mesh, const Ray& ray) noexcept {
    return trace<true>(tree, mesh, ray).has_value();
}

}  // namespace coppice
