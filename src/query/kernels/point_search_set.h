// Searches of a k-d tree over points near a query point and in a box, eight points at a time.
//
// Near a point: the nearer child is visited first, and the other is pushed on a stack with a lower
// bound of its squared distance. The bound is updated one axis at a time [AryaMount1993]: on the
// axis of the plane it becomes the distance to the plane, on the other axes it stays. Bounds and
// distances are the same sums of three squares in double. A bound's terms are at most those of any
// point beyond the planes, and rounding preserves order. So no point is skipped that brute force
// would find, ties included.
//
// Stack: at most one entry per level, and no leaf is deeper than KdTree::max_depth. One more entry
// is needed because it is written before it is known whether it counts.

#include "simd/set.h"

#if defined(COPPICE_QUERY_KERNELS_POINT_SEARCH_SET_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_QUERY_KERNELS_POINT_SEARCH_SET_H
#else
#define COPPICE_QUERY_KERNELS_POINT_SEARCH_SET_H
#endif

#include "coppice/geom/aabb.h"
#include "coppice/tree/kd_tree.h"

#include "query/kernels/point_search.h"
#include "query/nearest_set.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

constexpr std::size_t max_stack = static_cast<std::size_t>(KdTree::max_depth) + 1;

// The squared distances of eight points, in two registers of four.
class PointDistances {
public:
    // Computes them for the eight points from `first` on.
    PointDistances(const SearchedPoints& points, std::size_t first,
                   const std::array<double, 3>& from) noexcept {
        const Lanes x = load_unaligned(points.x + first);
        const Lanes y = load_unaligned(points.y + first);
        const Lanes z = load_unaligned(points.z + first);
        lower_ = measure(lower_half(x), lower_half(y), lower_half(z), from);
        upper_ = measure(upper_half(x), upper_half(y), upper_half(z), from);
    }

    // A mask of the points whose squared distance is at most `limit`: bit i for point i.
    [[nodiscard]] unsigned mask_within(double limit) const noexcept {
        const Doubles limits = broadcast_double(limit);
        return less_equal(lower_, limits) | less_equal(upper_, limits) << half_count;
    }

    void store_to(std::array<double, point_lanes>& distances) const noexcept {
        store(lower_, distances.data());
        store(upper_, distances.data() + half_count);
    }

private:
    static constexpr std::size_t half_count = point_lanes / 2;

    static Doubles measure(Quad x, Quad y, Quad z, const std::array<double, 3>& from) noexcept {
        const Doubles dx = to_doubles(x) - broadcast_double(from[0]);
        const Doubles dy = to_doubles(y) - broadcast_double(from[1]);
        const Doubles dz = to_doubles(z) - broadcast_double(from[2]);
        return dx * dx + dy * dy + dz * dz;
    }

    Doubles lower_;
    Doubles upper_;
};

// The result of a search for the nearest point.
struct NearestOne {
    Neighbor& found;
    double reach;

    [[nodiscard]] double limit() const noexcept { return reach; }

    void offer(const Neighbor& other) noexcept {
        if (other.distance_squared > reach) return;
        if (other.distance_squared == found.distance_squared && other.prim > found.prim) return;
        found = other;
        reach = other.distance_squared;
    }
};

// The results of a search for all points within a distance. A limit of -1 ends the search.
struct AllWithin {
    Visitor<Neighbor> visit;
    double reach;

    [[nodiscard]] double limit() const noexcept { return reach; }

    void offer(const Neighbor& other) noexcept {
        if (other.distance_squared <= reach && !visit(other)) reach = -1.0;
    }
};

template <typename Keeper>
class Search {
public:
    Search(const SearchedPoints& points, Vec3f from, Keeper& keeper) noexcept
        : points_(points),
          nodes_(points.tree.nodes().data()),
          references_(points.tree.references().data()),
          from_{from.x, from.y, from.z},
          keeper_(keeper) {}

    void run() noexcept {
        Entry at = make_root();
        if (!(at.bound <= keeper_.limit())) return;
        do {
            while (!nodes_[at.node].is_leaf()) {
                step_down(at);
            }
            visit_leaf(nodes_[at.node]);
        } while (pop(at));
    }

private:
    using Squares = std::array<double, 3>;  // of the distances to a node's cell on each axis

    struct Entry {
        Squares squares;
        double bound;
        std::uint32_t node;
    };

    static double sum_of(const Squares& squares) noexcept {
        return squares[0] + squares[1] + squares[2];
    }

    [[nodiscard]] Entry make_root() const noexcept {
        const Aabb& box = points_.tree.bounds();
        Entry root{{}, 0.0, 0};
        for (const Axis axis : all_axes) {
            const double from = from_[static_cast<std::size_t>(axis)];
            const double outside =
                std::max(0.0, std::max(box.lower[axis] - from, from - box.upper[axis]));
            root.squares[static_cast<std::size_t>(axis)] = outside * outside;
        }
        root.bound = sum_of(root.squares);
        return root;
    }

    // Pops the next entry within the limit; returns false if there is none.
    bool pop(Entry& at) noexcept {
        while (size_ > 0) {
            if (stack_[--size_].bound > keeper_.limit()) continue;
            at = stack_[size_];
            return true;
        }
        return false;
    }

    // Descends to the nearer child and pushes the other one if it is within the limit.
    void step_down(Entry& at) noexcept {
        const KdNode& node = nodes_[at.node];
        const auto axis = static_cast<std::size_t>(node.axis());
        const double beyond = from_[axis] - static_cast<double>(node.position());
        const std::uint32_t is_above = beyond > 0.0 ? 1 : 0;
        Entry& far = stack_[size_];
        far.squares = at.squares;
        far.squares[axis] = beyond * beyond;
        far.bound = sum_of(far.squares);
        far.node = node.lower_child() + (1 - is_above);
        size_ += far.bound <= keeper_.limit() ? 1 : 0;
        at.node = node.lower_child() + is_above;
    }

    void visit_leaf(const KdNode& leaf) noexcept {
        const std::size_t end = leaf.first_reference() + std::size_t{leaf.reference_count()};
        for (std::size_t at = leaf.first_reference(); at < end; at += point_lanes) {
            const PointDistances measured(points_, at, from_);
            unsigned rest = measured.mask_within(keeper_.limit());
            if (end - at < point_lanes) rest &= (1U << (end - at)) - 1U;
            if (rest == 0) continue;
            alignas(32) std::array<double, point_lanes> distances;
            measured.store_to(distances);
            for (; rest != 0; rest &= rest - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
                keeper_.offer({distances[lane], references_[at + lane]});
            }
        }
    }

    const SearchedPoints& points_;
    const KdNode* nodes_;
    const std::uint32_t* references_;
    Squares from_;
    Keeper& keeper_;
    std::size_t size_ = 0;
    std::array<Entry, max_stack> stack_;
};

void nearest(const SearchedPoints& points, Vec3f point, double limit, Neighbor& found) noexcept {
    NearestOne keeper{found, limit};
    Search<NearestOne>(points, point, keeper).run();
}

std::size_t nearest_k(const SearchedPoints& points, Vec3f point, double limit,
                      std::span<Neighbor> found) noexcept {
    NearestSet<Neighbor> keeper(found, limit);
    Search<NearestSet<Neighbor>>(points, point, keeper).run();
    return keeper.sort();
}

void within(const SearchedPoints& points, Vec3f point, double limit,
            Visitor<Neighbor> visit) noexcept {
    AllWithin keeper{visit, limit};
    Search<AllWithin>(points, point, keeper).run();
}

void overlapping(const SearchedPoints& points, const Aabb& box,
                 Visitor<std::uint32_t> visit) noexcept {
    const auto is_inside = [&](std::size_t at) {
        return box.contains({points.x[at], points.y[at], points.z[at]});
    };
    std::array<std::uint32_t, max_stack> stack;
    stack[0] = 0;
    for (std::size_t size = 1; size > 0;) {
        const KdNode& node = points.tree.nodes()[stack[--size]];
        if (!node.is_leaf()) {
            const Axis axis = node.axis();
            if (box.upper[axis] >= node.position()) stack[size++] = node.upper_child();
            if (box.lower[axis] <= node.position()) stack[size++] = node.lower_child();
            continue;
        }
        const std::size_t end = node.first_reference() + std::size_t{node.reference_count()};
        for (std::size_t at = node.first_reference(); at < end; ++at) {
            if (is_inside(at) && !visit(points.tree.references()[at])) return;
        }
    }
}

constexpr PointSearchKernels kernels{&nearest, &nearest_k, &within, &overlapping};

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

COPPICE_SIMD_END

#endif
