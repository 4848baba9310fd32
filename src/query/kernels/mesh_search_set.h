// Searches of the 8-wide tree near a point and in a box.
//
// Near a point: branch and bound, the nearest box first. Distances to boxes and triangles are
// bounded from below in float, eight at a time. For the few triangles that remain (one or two a
// leaf), closest_point() computes the distance in double. So results equal those of brute force on
// every instruction set. A tree with cells by planes has some triangles in several leaves. Such a
// triangle is reported for the first block with it that the query reaches.
// Source: [Roussopoulos1995] sec. 3 and 4 (depth first with sorted branches there, too).
//
// Stack: an inner node leaves at most 7 entries, and no node is deeper than Bvh8::max_depth.

#include "simd/set.h"

#if defined(COPPICE_QUERY_KERNELS_MESH_SEARCH_SET_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_QUERY_KERNELS_MESH_SEARCH_SET_H
#else
#define COPPICE_QUERY_KERNELS_MESH_SEARCH_SET_H
#endif

#include "coppice/geom/aabb.h"
#include "coppice/geom/closest_point.h"
#include "coppice/geom/overlap.h"
#include "coppice/tree/bvh8.h"

#include "query/kernels/mesh_bounds.h"
#include "query/kernels/mesh_search.h"
#include "query/nearest_set.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

constexpr unsigned all_lanes = (1U << bvh8_width) - 1;

constexpr std::size_t max_stack = (bvh8_width - 1) * (Bvh8::max_depth + 1);

inline unsigned lanes_with_triangle(const TriangleBlock& block) noexcept {
    unsigned mask = 0;
    for (unsigned lane = 0; lane < bvh8_width; ++lane) {
        mask |= (block.id[lane] != TriangleBlock::no_triangle ? 1U : 0U) << lane;
    }
    return mask;
}

inline std::size_t lowest_lane(unsigned mask) noexcept {
    return static_cast<std::size_t>(std::countr_zero(mask));
}

// A mask of the children whose boxes overlap `box`: bit i for child i.
inline unsigned mask_overlapping(const Bvh8Node& node, const Aabb& box) noexcept {
    const auto on = [&](std::size_t row, float lower, float upper) {
        return less_equal(load(node.bound[row]), broadcast(upper)) &
               less_equal(broadcast(lower), load(node.bound[3 + row]));
    };
    return on(0, box.lower.x, box.upper.x) & on(1, box.lower.y, box.upper.y) &
           on(2, box.lower.z, box.upper.z);
}

// A mask of the triangles whose boxes overlap `box`: bit i for lane i. Bits of lanes without a
// triangle are arbitrary.
inline unsigned mask_overlapping(const TriangleBlock& block, const Aabb& box) noexcept {
    unsigned apart = 0;
    for (const Axis axis : all_axes) {
        const auto row = static_cast<std::size_t>(axis);
        const Lanes a = load(block.corner[0][row]);
        const Lanes b = load(block.corner[1][row]);
        const Lanes c = load(block.corner[2][row]);
        apart |= less(max(a, max(b, c)), broadcast(box.lower[axis])) |
                 less(broadcast(box.upper[axis]), min(a, min(b, c)));
    }
    return apart ^ all_lanes;
}

// Calls `visit` with the leaves that a query reaches, until it returns false. `reached_by(node)`
// returns the mask of the node's children that the query reaches.
template <typename ReachedBy, typename Visit>
inline void visit_leaves(const Bvh8& tree, const ReachedBy& reached_by,
                         const Visit& visit) noexcept {
    std::array<Bvh8Child, max_stack> stack;
    stack[0] = Bvh8Child::make_inner(0);
    for (std::size_t size = 1; size > 0;) {
        const Bvh8Node& node = tree.nodes()[stack[--size].node()];
        for (unsigned rest = reached_by(node); rest != 0; rest &= rest - 1) {
            const Bvh8Child child = node.child[lowest_lane(rest)];
            if (child.is_empty()) break;  // all after it are empty, too
            if (!child.is_leaf()) {
                stack[size++] = child;
            } else if (!visit(child)) {
                return;
            }
        }
    }
}

// True if no earlier block with the triangle is reached by the query. Used for triangles in several
// leaves, so that each is reported once.
template <typename ReachedBy>
inline bool is_first_mention(const Bvh8& tree, const ReachedBy& reached_by,
                             const TriangleBlock& block, std::size_t lane) noexcept {
    const std::uint32_t id = block.id[lane];
    const Aabb box = triangle_bounds(block.triangle(lane));
    bool is_first = true;
    visit_leaves(
        tree, [&](const Bvh8Node& node) { return reached_by(node) & mask_overlapping(node, box); },
        [&](Bvh8Child leaf) {
            const TriangleBlock* other = &tree.blocks()[leaf.first_block()];
            const TriangleBlock* end = other + leaf.block_count();
            for (; other != end && other < &block; ++other) {
                for (const std::uint32_t mentioned : other->id) {
                    is_first &= mentioned != id;
                }
            }
            return is_first;
        });
    return is_first;
}

// The result of a search for the nearest triangle.
struct NearestOne {
    SurfaceNeighbor& found;
    double reach;

    [[nodiscard]] double limit() const noexcept { return reach; }

    void offer(const SurfaceNeighbor& other, const TriangleBlock& /*block*/,
               std::size_t /*lane*/) noexcept {
        if (other.distance_squared > reach) return;
        if (other.distance_squared == found.distance_squared && other.prim > found.prim) return;
        found = other;
        reach = other.distance_squared;
    }
};

// The results of a search for the k nearest triangles.
struct NearestMany {
    const SearchedMesh& mesh;
    NearestSet<SurfaceNeighbor> found;

    [[nodiscard]] double limit() const noexcept { return found.limit(); }

    void offer(const SurfaceNeighbor& other, const TriangleBlock& /*block*/,
               std::size_t /*lane*/) noexcept {
        if (mesh.is_repeated(other.prim) && found.contains(other.prim)) return;
        found.offer(other);
    }
};

// The results of a search for all triangles within a distance. A limit of -1 ends the search.
struct AllWithin {
    const SearchedMesh& mesh;
    const ScaledPoint point;
    Visitor<SurfaceNeighbor> visit;
    double reach;
    bool is_ended = false;

    [[nodiscard]] double limit() const noexcept { return is_ended ? -1.0 : reach; }

    void offer(const SurfaceNeighbor& other, const TriangleBlock& block,
               std::size_t lane) noexcept {
        if (is_ended || other.distance_squared > reach) return;
        const auto reached_by = [&](const Bvh8Node& node) {
            return less_equal(bound_boxes(node, point), broadcast(point.scaled_up(reach)));
        };
        if (mesh.is_repeated(other.prim) && !is_first_mention(mesh.tree, reached_by, block, lane)) {
            return;
        }
        is_ended = !visit(other);
    }
};

template <typename Keeper>
class Search {
public:
    Search(const Bvh8& tree, Vec3f point, Keeper& keeper) noexcept
        : tree_(tree),
          from_(point),
          point_(point, tree.bounds()),
          keeper_(keeper),
          limit_(point_.scaled_up(keeper.limit())) {}

    void run() noexcept {
        Entry at{0.0F, Bvh8Child::make_inner(0)};
        do {
            while (!at.child.is_leaf()) {
                if (!step_down(tree_.nodes()[at.child.node()], at)) break;
            }
            if (at.child.is_leaf()) visit_leaf(at.child);
        } while (pop(at));
    }

private:
    struct Entry {
        float bound;
        Bvh8Child child;
    };

    // Pops the next entry within the limit; returns false if there is none.
    bool pop(Entry& at) noexcept {
        while (size_ > 0) {
            at = stack_[--size_];
            if (at.bound <= limit_) return true;
        }
        return false;
    }

    // Descends to the nearest child within the limit and pushes the other ones, the nearest on top.
    // Returns false if there is none.
    bool step_down(const Bvh8Node& node, Entry& at) noexcept {
        const Lanes bound = bound_boxes(node, point_);
        const unsigned mask = less_equal(bound, broadcast(limit_));
        if (mask == 0) return false;
        alignas(32) std::array<float, bvh8_width> bounds;
        store(bound, bounds);
        const auto entry_of = [&](std::size_t slot) {
            return Entry{bounds[slot], node.child[slot]};
        };
        at = entry_of(lowest_lane(mask));
        const std::size_t first = size_;
        for (unsigned rest = mask & (mask - 1); rest != 0; rest &= rest - 1) {
            Entry other = entry_of(lowest_lane(rest));
            if (other.bound < at.bound) std::swap(other, at);
            std::size_t place = size_++;
            for (; place > first && stack_[place - 1].bound < other.bound; --place) {
                stack_[place] = stack_[place - 1];
            }
            stack_[place] = other;
        }
        return true;
    }

    void visit_leaf(Bvh8Child leaf) noexcept {
        const TriangleBlock* block = &tree_.blocks()[leaf.first_block()];
        for (std::uint32_t count = leaf.block_count(); count > 0; --count, ++block) {
            visit_block(*block);
        }
    }

    // Tests the triangles whose bounds are within the limit, the most promising first.
    void visit_block(const TriangleBlock& block) noexcept {
        const Lanes bound = bound_triangles(block, point_);
        unsigned rest = less_equal(bound, broadcast(limit_)) & lanes_with_triangle(block);
        alignas(32) std::array<float, bvh8_width> bounds;
        store(bound, bounds);
        while (rest != 0) {
            std::size_t nearest = lowest_lane(rest);
            for (unsigned others = rest & (rest - 1); others != 0; others &= others - 1) {
                const std::size_t other = lowest_lane(others);
                if (bounds[other] < bounds[nearest]) nearest = other;
            }
            if (bounds[nearest] > limit_) return;
            test(block, nearest);
            rest &= ~(1U << nearest);
        }
    }

    void test(const TriangleBlock& block, std::size_t lane) noexcept {
        const ClosestPoint closest = closest_point(block.triangle(lane), from_);
        if (closest.distance_squared > keeper_.limit()) return;
        keeper_.offer({closest.distance_squared, closest.point, closest.u, closest.v,
                       block.id[lane], closest.feature},
                      block, lane);
        limit_ = point_.scaled_up(keeper_.limit());
    }

    const Bvh8& tree_;
    Vec3f from_;
    ScaledPoint point_;
    Keeper& keeper_;
    float limit_;
    std::size_t size_ = 0;
    std::array<Entry, max_stack> stack_;
};

void nearest(const SearchedMesh& mesh, Vec3f point, double limit, SurfaceNeighbor& found) noexcept {
    NearestOne keeper{found, limit};
    Search<NearestOne>(mesh.tree, point, keeper).run();
}

std::size_t nearest_k(const SearchedMesh& mesh, Vec3f point, double limit,
                      std::span<SurfaceNeighbor> found) noexcept {
    NearestMany keeper{mesh, {found, limit}};
    Search<NearestMany>(mesh.tree, point, keeper).run();
    return keeper.found.sort();
}

void within(const SearchedMesh& mesh, Vec3f point, double limit,
            Visitor<SurfaceNeighbor> visit) noexcept {
    AllWithin keeper{mesh, {point, mesh.tree.bounds()}, visit, limit};
    Search<AllWithin>(mesh.tree, point, keeper).run();
}

void overlapping(const SearchedMesh& mesh, const Aabb& box, Visitor<std::uint32_t> visit) noexcept {
    const auto reached_by = [&](const Bvh8Node& node) { return mask_overlapping(node, box); };
    const auto is_new = [&](const TriangleBlock& block, std::size_t lane) {
        return !mesh.is_repeated(block.id[lane]) ||
               is_first_mention(mesh.tree, reached_by, block, lane);
    };
    visit_leaves(mesh.tree, reached_by, [&](Bvh8Child leaf) {
        const TriangleBlock* block = &mesh.tree.blocks()[leaf.first_block()];
        for (std::uint32_t count = leaf.block_count(); count > 0; --count, ++block) {
            const unsigned near = mask_overlapping(*block, box);
            for (unsigned rest = near & lanes_with_triangle(*block); rest != 0; rest &= rest - 1) {
                const std::size_t lane = lowest_lane(rest);
                const bool is_found = overlaps(block->triangle(lane), box) && is_new(*block, lane);
                if (is_found && !visit(block->id[lane])) return false;
            }
        }
        return true;
    });
}

constexpr MeshSearchKernels kernels{&nearest, &nearest_k, &within, &overlapping};

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

COPPICE_SIMD_END

#endif
