// Traversal of the 8-wide tree by a ray packet.
//
// At a node, all boxes are first tested against the frustum of the eight rays. Each box that it
// meets is then tested against the eight rays at once. The packet descends to these boxes with the
// rays that meet them. Fewer than three rays continue as single rays. At a leaf, each ray's own
// query is asked, so hits equal those of single rays.

#include "simd/set.h"

#if defined(COPPICE_TRACE_KERNELS_PACKET_TRAVERSAL_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_TRACE_KERNELS_PACKET_TRAVERSAL_H
#else
#define COPPICE_TRACE_KERNELS_PACKET_TRAVERSAL_H
#endif

#include "coppice/geom/ray.h"
#include "coppice/tree/bvh8.h"

#include "trace/kernels/bvh8_boxes.h"
#include "trace/kernels/bvh8_queries.h"
#include "trace/kernels/bvh8_traversal.h"
#include "trace/kernels/ray_packet.h"

#include <algorithm>
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

template <typename Query>
class PacketTraversal {
public:
    PacketTraversal(const Bvh8& tree, const RayPacket& packet) noexcept
        : PacketTraversal(tree, packet, std::make_index_sequence<packet_size>{}) {}

    void run() noexcept {
        Bvh8Child at = Bvh8Child::make_inner(0);
        unsigned rays = alive_;
        for (;;) {
            if (at.is_leaf()) {
                visit_leaf(at, rays);
            } else if (std::popcount(rays) < 3) {
                go_alone(at, rays);
            } else if (step_down(tree_.nodes()[at.node()], at, rays)) {
                continue;
            }
            if (!pop(at, rays)) return;
        }
    }

    [[nodiscard]] Query& query(std::size_t i) noexcept { return members_[i].query; }

private:
    struct Member {
        explicit Member(const Ray& ray) noexcept : sheared(ray), query(ray, sheared) {}

        ShearedRay sheared;
        Query query;
    };

    // A waiting child, the mask of the rays that meet it, and a lower bound of their entry
    // distances.
    struct Entry {
        float enter;
        Bvh8Child child;
        unsigned rays;
    };

    template <std::size_t... I>
    PacketTraversal(const Bvh8& tree, const RayPacket& packet,
                    std::index_sequence<I...> /*indices*/) noexcept
        : tree_(tree), packet_(packet), members_{Member(packet.rays[I])...} {
        for (std::size_t i = 0; i < packet_size; ++i) {
            enter_[i] = members_[i].query.first();
            exit_[i] = members_[i].query.limit();
        }
        first_ = *std::min_element(enter_.begin(), enter_.end());
        set_limit();
    }

    void set_limit() noexcept { limit_ = *std::max_element(exit_.begin(), exit_.end()); }

    bool pop(Bvh8Child& at, unsigned& rays) noexcept {
        while (top_ != stack_.data()) {
            --top_;
            rays = top_->rays & alive_;
            at = top_->child;
            if (rays != 0 && (!Query::nearest_first || top_->enter <= limit_)) return true;
        }
        return false;
    }

    // Descends to one of the children that any ray meets, as Traversal does. Returns false if there
    // is none.
    bool step_down(const Bvh8Node& node, Bvh8Child& at, unsigned& rays) noexcept {
        const BoxHits met = packet_.frustum.meet(node, broadcast(first_), broadcast(limit_));
        if (met.mask == 0) return false;
        alignas(32) std::array<float, bvh8_width> enter;
        store(met.enter, enter);
        const Lanes first = load(enter_);
        const Lanes last = load(exit_);
        const Entry* const base = top_;
        for (unsigned rest = met.mask; rest != 0; rest &= rest - 1) {
            const auto slot = static_cast<std::size_t>(std::countr_zero(rest));
            const unsigned meeting = rays & packet_.each.meet_child(node, slot, first, last);
            if (meeting != 0) push({enter[slot], node.child[slot], meeting}, base);
        }
        if (top_ == base) return false;
        --top_;
        at = top_->child;
        rays = top_->rays;
        return true;
    }

    // Pushes an entry. Entries from `base` on are sorted, the nearest on top.
    void push(Entry entry, const Entry* base) noexcept {
        Entry* place = top_++;
        if (Query::nearest_first) {
            for (; place != base && place[-1].enter < entry.enter; --place) {
                *place = place[-1];
            }
        }
        *place = entry;
    }

    void visit_leaf(Bvh8Child leaf, unsigned rays) noexcept {
        const TriangleBlock* block = tree_.blocks().data() + leaf.first_block();
        for (std::uint32_t count = leaf.block_count(); count > 0; --count, ++block) {
            for (unsigned rest = rays & alive_; rest != 0; rest &= rest - 1) {
                const auto i = static_cast<std::size_t>(std::countr_zero(rest));
                Member& member = members_[i];
                if (show(*block, member.sheared, member.query)) alive_ &= ~(1U << i);
                exit_[i] = member.query.limit();
            }
        }
        if (Query::nearest_first) set_limit();
    }

    void go_alone(Bvh8Child at, unsigned rays) noexcept {
        for (; rays != 0; rays &= rays - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(rays));
            const FastRay fast = packet_.ray(i);
            Member& member = members_[i];
            Traversal alone(tree_, fast, member.sheared, member.query, NoCounts{});
            if (alone.run(at)) alive_ &= ~(1U << i);
            exit_[i] = member.query.limit();
        }
        if (Query::nearest_first) set_limit();
    }

    const Bvh8& tree_;
    const RayPacket& packet_;
    std::array<Member, packet_size> members_;
    alignas(32) OfRays enter_;
    alignas(32) OfRays exit_;
    float first_;
    float limit_;
    unsigned alive_ = 0xffU;
    std::array<Entry, max_stack> stack_;
    Entry* top_ = stack_.data();
};

// Traces an array of rays. Calls done(i, query) for each ray that was in a packet, and alone(i) for
// each other ray.
template <typename Query, typename Done, typename Alone>
void trace_in_packets(const Bvh8& tree, std::span<const Ray> rays, Done&& done,
                      Alone&& alone) noexcept {
    std::size_t i = 0;
    for (; i + packet_size <= rays.size(); i += packet_size) {
        RayPacket packet(rays.subspan(i).template first<packet_size>());
        if (packet.gather(tree.bounds())) {
            PacketTraversal<Query> traversal(tree, packet);
            traversal.run();
            for (std::size_t k = 0; k < packet_size; ++k) {
                done(i + k, traversal.query(k));
            }
        } else {
            for (std::size_t k = 0; k < packet_size; ++k) {
                alone(i + k);
            }
        }
    }
    for (; i < rays.size(); ++i) {
        alone(i);
    }
}

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

COPPICE_SIMD_END

#endif
