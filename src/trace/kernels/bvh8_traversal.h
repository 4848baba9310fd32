// Traversal of the 8-wide tree by a single ray.
//
// The ray descends to the nearest child that it meets, an any-hit query to the child most likely to
// be hit. The others are pushed on a stack. What single precision cannot decide is decided by
// TriangleTest's operations in double. So hits equal those of brute force on every instruction set,
// and the traversal is watertight.
//
// Stack: an inner node leaves at most 7 entries, and no node is deeper than Bvh8::max_depth.

#include "simd/set.h"

#if defined(COPPICE_TRACE_KERNELS_BVH8_TRAVERSAL_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_TRACE_KERNELS_BVH8_TRAVERSAL_H
#else
#define COPPICE_TRACE_KERNELS_BVH8_TRAVERSAL_H
#endif

#include "coppice/geom/ray.h"
#include "coppice/trace/traversal_counts.h"
#include "coppice/tree/bvh8.h"

#include "trace/kernels/bvh8_boxes.h"
#include "trace/kernels/bvh8_queries.h"
#include "trace/kernels/bvh8_triangles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

constexpr std::size_t max_stack = (bvh8_width - 1) * (Bvh8::max_depth + 1);

// A waiting child and the distance at which the ray enters it, packed into an integer. The nearer
// of two entries is the smaller integer if distances are not negative. Otherwise only the order of
// visits is worse.
class Entry {
public:
    Entry() = default;

    Entry(float enter, Bvh8Child child) noexcept
        : bits_(std::uint64_t{std::bit_cast<std::uint32_t>(enter)} << 32 |
                std::bit_cast<std::uint32_t>(child)) {}

    [[nodiscard]] float enter() const noexcept {
        return std::bit_cast<float>(static_cast<std::uint32_t>(bits_ >> 32));
    }

    [[nodiscard]] Bvh8Child child() const noexcept {
        return std::bit_cast<Bvh8Child>(static_cast<std::uint32_t>(bits_));
    }

    friend bool operator<(Entry a, Entry b) noexcept { return a.bits_ < b.bits_; }

private:
    std::uint64_t bits_;
};

// Counts nothing and costs nothing.
struct NoCounts {
    void add_node() noexcept {}

    void add_leaf(std::uint32_t /*blocks*/) noexcept {}
};

struct Counts {
    void add_node() noexcept { ++sum.nodes; }

    void add_leaf(std::uint32_t blocks) noexcept {
        ++sum.leaves;
        sum.primitives += bvh8_width * blocks;
    }

    TraversalCounts& sum;
};

template <typename BoxRay, typename Query, typename Counter>
class Traversal {
public:
    Traversal(const Bvh8& tree, const BoxRay& ray, const ShearedRay& sheared, Query& query,
              Counter counter) noexcept
        : nodes_(tree.nodes().data()),
          blocks_(tree.blocks().data()),
          ray_(ray),
          sheared_(sheared),
          query_(query),
          counter_(counter),
          enter_(broadcast(query.first())) {
        set_limit();
    }

    // Searches the subtree of a child. Returns true if the query has finished.
    bool run(Bvh8Child at = Bvh8Child::make_inner(0)) noexcept {
        for (;;) {
            if (!at.is_leaf()) {
                if (step_down(nodes_[at.node()], at)) continue;
            } else if (visit_leaf(at)) {
                return true;
            }
            if (!pop(at)) return false;
        }
    }

private:
    void set_limit() noexcept {
        limit_ = query_.limit();
        exit_ = broadcast(limit_);
    }

    // Pops the next entry within the limit; returns false if there is none.
    bool pop(Bvh8Child& at) noexcept {
        while (top_ != stack_.data()) {
            --top_;
            at = top_->child();
            const bool is_near = !Query::nearest_first || top_->enter() <= limit_;
            if (is_near && is_child(at)) return true;
        }
        return false;
    }

    // Descends to one of the children that the ray meets and pushes the others. Returns false if it
    // meets none.
    bool step_down(const Bvh8Node& node, Bvh8Child& at) noexcept {
        counter_.add_node();
        const BoxHits met = ray_.meet(node, enter_, exit_);
        if (met.mask == 0) return false;
        at = Query::nearest_first ? go_to_nearest(node, met) : go_to_last(node, met.mask);
        return is_child(at);
    }

    // Returns the nearest child and pushes the others, sorted with the nearest on top.
    Bvh8Child go_to_nearest(const Bvh8Node& node, const BoxHits& met) noexcept {
        unsigned rest = met.mask & (met.mask - 1);
        auto slot = static_cast<std::size_t>(std::countr_zero(met.mask));
        if (rest == 0) return node.child[slot];
        alignas(32) std::array<float, bvh8_width> enter;
        store(met.enter, enter);
        Entry nearest(enter[slot], node.child[slot]);
        const Entry* const base = top_;
        do {
            slot = static_cast<std::size_t>(std::countr_zero(rest));
            rest &= rest - 1;
            const Entry other(enter[slot], node.child[slot]);
            prefetch(other.child());
            const Entry farther = std::max(nearest, other);
            nearest = std::min(nearest, other);
            Entry* place = top_++;
            for (; place != base && place[-1] < farther; --place) {
                *place = place[-1];
            }
            *place = farther;
        } while (rest != 0);
        return nearest.child();
    }

    // Returns the last child, which the builder places last because it is the most likely to be
    // hit.
    Bvh8Child go_to_last(const Bvh8Node& node, unsigned mask) noexcept {
        for (;;) {
            const Bvh8Child child = node.child[static_cast<std::size_t>(std::countr_zero(mask))];
            mask &= mask - 1;
            if (mask == 0) return child;
            prefetch(child);
            *top_++ = Entry(0.0F, child);
        }
    }

    // True if a slot whose box is met holds a child.
    static bool is_child(Bvh8Child met) noexcept {
        return BoxRay::never_meets_empty || !met.is_empty();
    }

    void prefetch(Bvh8Child child) const noexcept {
        const char* at = child.is_leaf()
                             ? reinterpret_cast<const char*>(blocks_ + child.first_block())
                             : reinterpret_cast<const char*>(nodes_ + child.node());
        constexpr std::size_t line = 64;
        for (std::size_t i = 0; i < sizeof(TriangleBlock); i += line) {
            __builtin_prefetch(at + i);
        }
    }

    // Returns true if the search has finished.
    bool visit_leaf(Bvh8Child leaf) noexcept {
        counter_.add_leaf(leaf.block_count());
        const TriangleBlock* block = blocks_ + leaf.first_block();
        for (std::uint32_t count = leaf.block_count(); count > 0; --count, ++block) {
            if (show(*block, sheared_, query_)) return true;
            if (Query::nearest_first) set_limit();
        }
        return false;
    }

    const Bvh8Node* nodes_;
    const TriangleBlock* blocks_;
    const BoxRay& ray_;
    const ShearedRay& sheared_;
    Query& query_;
    [[no_unique_address]] Counter counter_;
    Lanes enter_;
    Lanes exit_;
    float limit_;
    std::array<Entry, max_stack> stack_;
    Entry* top_ = stack_.data();
};

// Runs a query through the tree, if the ray is traceable.
template <typename Query, typename Counter>
void search(const Bvh8& tree, const Ray& ray, const ShearedRay& sheared, Query& query,
            Counter counter) noexcept {
    if (is_fast(ray, tree.bounds())) {
        const FastRay fast(ray);
        Traversal(tree, fast, sheared, query, counter).run();
    } else if (is_traceable(ray)) {
        const RobustRay robust(ray, tree.bounds());
        Traversal(tree, robust, sheared, query, counter).run();
    }
}

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

COPPICE_SIMD_END

#endif
