// Ordered traversal of the k-d tree. At each inner node the ray's interval is cut at the plane, the
// nearer child is visited first, and the other is pushed on a stack. Closest hit, any hit and all
// hits are one template over a query, which decides what is done with a hit. Counting is a second
// parameter.
//
// No leaf that the ray touches is skipped:
// - The distance of a plane is (position - origin) * (1 / direction), in double from float input.
//   Its three roundings make an error below 2^-51 of its value. Nothing overflows or underflows:
//   the numbers are between 2^-149 and 2^129, and reciprocals are below 2^149. Where a plane sets
//   an end of an interval, the end is moved outward by 2^-40 of its value. That covers its own
//   error and the error of all distances compared with it. The scale and the sign of t do not
//   matter.
// - A direction component of 0 has the reciprocal +inf, one of -0 has -inf, and the sign determines
//   which child is the near one. For an origin off the plane the distance is then +inf, so that
//   only the near child is visited, or -inf, so that only the far one is. In both cases that is the
//   child on the origin's side.
// - For a ray within the plane the distance is NaN. It compares false with both ends, so both
//   children are visited, and the minimum and maximum below keep the interval as it is. Both must
//   be visited, because either may hold triangles that touch the plane or lie in it.
// - For an origin on the plane that the ray leaves, the distance is exactly 0. The near child is
//   visited if the interval has t <= 0, the far one if it has t >= 0.
// - Hits are compared by their t rounded to float; limits are widened by that rounding.
//
// The stack cannot overflow. A node is pushed while the ray descends to its sibling, so waiting
// nodes have different depths. The root is never among them, and no tree is deeper than
// KdTree::max_depth (builders stop there, validate() reports deeper trees).
//
// Cost: a subtraction, a product and two comparisons for an inner node; a triangle test in double
// for a reference. A triangle in several leaves is tested in each.
// Source: [Pharr2016] sec. 4.4.3 (ordered traversal with a stack).

#include "coppice/trace/intersect.h"

#include "coppice/geom/triangle.h"

#include "trace/hit_list.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::inline v0 {
namespace {

// Moves an end of an interval outward by more than the error of a distance.
double before(double distance) noexcept {
    return distance - 0x1.0p-40 * std::abs(distance);
}

double behind(double distance) noexcept {
    return distance + 0x1.0p-40 * std::abs(distance);
}

// An upper bound of the difference between a distance and the float it is rounded to.
double rounding_of(float t) noexcept {
    return 0x1.0p-22 * std::abs(static_cast<double>(t)) + 0x1.0p-149;
}

// An interval of the ray and the node to search in it.
struct Entry {
    std::uint32_t node;
    double enter;
    double exit;
};

// A ray in the form that plane distances need, component by axis.
class PlaneRay {
public:
    explicit PlaneRay(const Ray& ray) noexcept {
        for (const Axis axis : all_axes) {
            const auto at = static_cast<std::size_t>(axis);
            origin_[at] = ray.origin[axis];
            inverse_[at] = 1.0 / static_cast<double>(ray.direction[axis]);
            near_side_[at] = std::signbit(ray.direction[axis]) ? 1 : 0;
        }
    }

    // The signed distance to a plane; see the top of this file.
    [[nodiscard]] double distance(Axis axis, float position) const noexcept {
        const auto at = static_cast<std::size_t>(axis);
        return (static_cast<double>(position) - origin_[at]) * inverse_[at];
    }

    // 0 if the ray reaches the lower side of a plane first, else 1.
    [[nodiscard]] std::uint32_t near_side(Axis axis) const noexcept {
        return near_side_[static_cast<std::size_t>(axis)];
    }

    // The interval of the ray inside a box, widened by rounding; empty (enter > exit) if the ray
    // misses it. It extends slightly beyond t_min and t_max, because hits there may be rounded to
    // them.
    [[nodiscard]] Entry clip(const Ray& ray, const Aabb& box) const noexcept {
        Entry inside{0, ray.t_min - rounding_of(ray.t_min), ray.t_max + rounding_of(ray.t_max)};
        for (const Axis axis : all_axes) {
            if (ray.direction[axis] == 0.0F) {
                const bool is_beside =
                    ray.origin[axis] < box.lower[axis] || ray.origin[axis] > box.upper[axis];
                if (is_beside) return {0, 1.0, 0.0};
                continue;
            }
            const bool is_down = near_side(axis) == 1;
            const double near = distance(axis, is_down ? box.upper[axis] : box.lower[axis]);
            const double far = distance(axis, is_down ? box.lower[axis] : box.upper[axis]);
            inside.enter = std::max(inside.enter, before(near));
            inside.exit = std::min(inside.exit, behind(far));
        }
        return inside;
    }

private:
    std::array<double, 3> origin_;
    std::array<double, 3> inverse_;
    std::array<std::uint32_t, 3> near_side_;
};

// Keeps the closest hit so far, or the first one if `any_hit`. A query decides what is done with
// hits.
template <bool any_hit>
class OneHitQuery {
public:
    explicit OneHitQuery(const Ray& ray) noexcept { hit_.t = ray.t_max; }

    // True if the search is over.
    bool take(const Hit& hit) noexcept {
        if (has_hit_ && !is_before(hit, hit_)) return false;
        hit_ = hit;
        has_hit_ = true;
        return any_hit;
    }

    // Hits beyond this distance are not needed.
    [[nodiscard]] float t_max() const noexcept { return hit_.t; }

    [[nodiscard]] std::optional<Hit> result() const noexcept {
        return has_hit_ ? std::optional(hit_) : std::nullopt;
    }

private:
    Hit hit_;
    bool has_hit_ = false;
};

using ClosestHitQuery = OneHitQuery<false>;
using AnyHitQuery = OneHitQuery<true>;

// Collects the first hits in order, as many as the list has room for.
class FirstKHitsQuery {
public:
    FirstKHitsQuery(const Ray& ray, HitList& list) noexcept : t_max_(ray.t_max), list_(list) {}

    bool take(const Hit& hit) noexcept {
        list_.insert(hit);
        if (list_.is_full()) t_max_ = list_.last_distance();
        return false;
    }

    [[nodiscard]] float t_max() const noexcept { return t_max_; }

private:
    float t_max_;
    HitList& list_;
};

// Counts nothing and costs nothing.
struct NoCounts {
    static void add_node() noexcept {}

    static void add_leaf(std::size_t /*primitive_count*/) noexcept {}
};

struct Counter {
    void add_node() noexcept { ++counts.nodes; }

    void add_leaf(std::size_t primitive_count) noexcept {
        ++counts.leaves;
        counts.primitives += primitive_count;
    }

    TraversalCounts& counts;
};

template <typename Query, typename Counts>
class Traversal {
public:
    Traversal(const KdTree& tree, TriangleMeshView mesh, const Ray& ray, Query& query,
              Counts counts) noexcept
        : tree_(tree),
          mesh_(mesh),
          ray_(ray),
          planes_(ray),
          test_(ray),
          query_(query),
          counts_(counts) {}

    void run() noexcept {
        Entry at = planes_.clip(ray_, tree_.bounds());
        if (!(at.enter <= at.exit)) return;
        do {
            const KdNode node = go_down(at);
            if (visit_leaf(node)) return;
        } while (pop(at));
    }

private:
    // Descends to the first leaf that the ray meets at or below a node. Pushes the siblings on the
    // way that the ray meets later.
    KdNode go_down(Entry& at) noexcept {
        const KdNode* nodes = tree_.nodes().data();
        KdNode node = nodes[at.node];
        while (!node.is_leaf()) {
            counts_.add_node();
            const Axis axis = node.axis();
            const double to_plane = planes_.distance(axis, node.position());
            const std::uint32_t near = node.lower_child() + planes_.near_side(axis);
            const std::uint32_t far = node.upper_child() - planes_.near_side(axis);
            if (to_plane > at.exit) {
                at.node = near;
            } else if (to_plane < at.enter) {
                at.node = far;
            } else {
                // The order of arguments matters: if a distance is NaN, the result is the
                // interval's own end.
                stack_[size_++] = {far, std::max(at.enter, before(to_plane)), at.exit};
                at.node = near;
                at.exit = std::min(at.exit, behind(to_plane));
            }
            node = nodes[at.node];
        }
        return node;
    }

    // True if the search is over.
    bool visit_leaf(const KdNode& leaf) noexcept {
        const auto ids = tree_.references(leaf);
        counts_.add_leaf(ids.size());
        for (const std::uint32_t id : ids) {
            auto hit = test_(mesh_.triangle(id), query_.t_max());
            if (!hit) continue;
            hit->prim = id;
            if (query_.take(*hit)) return true;
        }
        return false;
    }

    // Pops the next entry that may contain a hit that counts; returns false if there is none.
    bool pop(Entry& at) noexcept {
        const float t_max = query_.t_max();
        const double limit = t_max + rounding_of(t_max);
        while (size_ > 0) {
            at = stack_[--size_];
            if (at.enter <= limit) return true;
        }
        return false;
    }

    const KdTree& tree_;
    TriangleMeshView mesh_;
    const Ray& ray_;
    PlaneRay planes_;
    TriangleTest test_;
    Query& query_;
    Counts counts_;
    std::size_t size_ = 0;
    std::array<Entry, KdTree::max_depth> stack_;
};

template <typename Query, typename Counts>
void trace(const KdTree& tree, TriangleMeshView mesh, const Ray& ray, Query& query,
           Counts counts) noexcept {
    if (is_traceable(ray)) Traversal<Query, Counts>(tree, mesh, ray, query, counts).run();
}

template <typename Query, typename Counts>
std::optional<Hit> find_hit(const KdTree& tree, TriangleMeshView mesh, const Ray& ray,
                            Counts counts) noexcept {
    Query query(ray);
    trace(tree, mesh, ray, query, counts);
    return query.result();
}

}  // namespace

std::optional<Hit> intersect(const KdTree& tree, TriangleMeshView mesh, const Ray& ray) noexcept {
    return find_hit<ClosestHitQuery>(tree, mesh, ray, NoCounts());
}

std::optional<Hit> intersect(const KdTree& tree, TriangleMeshView mesh, const Ray& ray,
                             TraversalCounts& counts) noexcept {
    return find_hit<ClosestHitQuery>(tree, mesh, ray, Counter{counts});
}

bool occluded(const KdTree& tree, TriangleMeshView mesh, const Ray& ray) noexcept {
    return find_hit<AnyHitQuery>(tree, mesh, ray, NoCounts()).has_value();
}

bool occluded(const KdTree& tree, TriangleMeshView mesh, const Ray& ray,
              TraversalCounts& counts) noexcept {
    return find_hit<AnyHitQuery>(tree, mesh, ray, Counter{counts}).has_value();
}

std::size_t intersect_all(const KdTree& tree, TriangleMeshView mesh, const Ray& ray,
                          std::span<Hit> hits, const Hit* after) noexcept {
    if (hits.empty()) return 0;
    HitList list(hits, after);
    Ray rest = ray;
    rest.t_min = std::max(ray.t_min, list.first_distance());
    FirstKHitsQuery query(rest, list);
    trace(tree, mesh, rest, query, NoCounts());
    return list.size();
}

std::size_t count_hits(const KdTree& tree, TriangleMeshView mesh, const Ray& ray) noexcept {
    return count_by([&](std::span<Hit> hits, const Hit* after) {
        return intersect_all(tree, mesh, ray, hits, after);
    });
}

}  // namespace coppice::inline v0
