// The queries of the 8-wide tree's traversal. A query gives the limits within which boxes matter,
// and receives the triangles that may be hit, one at a time.

#include "simd/set.h"

#if defined(COPPICE_TRACE_KERNELS_BVH8_QUERIES_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_TRACE_KERNELS_BVH8_QUERIES_H
#else
#define COPPICE_TRACE_KERNELS_BVH8_QUERIES_H
#endif

#include "coppice/geom/ray.h"
#include "coppice/tree/bvh8.h"

#include "trace/hit_list.h"
#include "trace/kernels/bvh8_boxes.h"
#include "trace/kernels/bvh8_triangles.h"
#include "trace/kernels/decide.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <span>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

// Hits are compared by their rounded t, so those slightly outside an interval may belong to it.
// above() and below() move a limit outward accordingly. The smallest slack is far above the
// denormal numbers, whose arithmetic is slow.
inline float above(float t) noexcept {
    return std::max(t * shrink, t * grow) + 0x1.0p-100F;
}

inline float below(float t) noexcept {
    return std::min(t * shrink, t * grow) - 0x1.0p-100F;
}

// The distance from which boxes matter. Not below 0, except for rays whose t_min is negative.
inline float first_of(float t_min) noexcept {
    return t_min < 0.0F ? below(t_min) : std::max(below(t_min), 0.0F);
}

// Passes the triangles of a block that may be hit to a query. Returns true if the query has
// finished.
template <typename Query>
inline bool show(const TriangleBlock& block, const ShearedRay& ray, Query& query) noexcept {
    Sifted sifted;
    sift_triangles(block, ray, sifted);
    for (unsigned rest = sifted.possible; rest != 0; rest &= rest - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
        if (query.consider(block, lane, sifted)) return true;
    }
    return false;
}

// Finds out whether anything is hit.
class AnyHitQuery {
public:
    static constexpr bool nearest_first = false;

    AnyHitQuery(const Ray& ray, const ShearedRay& sheared) noexcept
        : ray_(ray), sheared_(sheared) {}

    [[nodiscard]] float first() const noexcept { return first_of(ray_.t_min); }

    [[nodiscard]] float limit() const noexcept { return above(ray_.t_max); }

    // Returns true if the search has finished.
    bool consider(const TriangleBlock& block, std::size_t lane, const Sifted& sifted) noexcept {
        const bool is_certain = (sifted.certain >> lane & 1U) != 0;
        if (is_certain && (sifted.first[lane] > ray_.t_max || sifted.last[lane] < ray_.t_min)) {
            return false;
        }
        // A hit beyond the range of float does not count.
        const float farthest = std::min(ray_.t_max, std::numeric_limits<float>::max());
        const bool is_inside = sifted.first[lane] >= ray_.t_min && sifted.last[lane] <= farthest;
        Hit hit;
        is_hit_ =
            (is_certain && is_inside) || decide(block, lane, ray_, sheared_.axes, ray_.t_max, hit);
        return is_hit_;
    }

    [[nodiscard]] bool is_hit() const noexcept { return is_hit_; }

private:
    const Ray& ray_;
    const ShearedRay& sheared_;
    bool is_hit_ = false;
};

// Finds the closest hit. Single precision gives each certain hit an interval of t. As long as these
// intervals do not overlap, they decide which hit is closer. Only overlapping hits and the final
// one are computed in double precision.
class ClosestHitQuery {
public:
    static constexpr bool nearest_first = true;

    ClosestHitQuery(const Ray& ray, const ShearedRay& sheared) noexcept
        : ray_(ray), sheared_(sheared), first_(ray.t_max), last_(ray.t_max) {}

    [[nodiscard]] float first() const noexcept { return first_of(ray_.t_min); }

    [[nodiscard]] float limit() const noexcept { return above(last_); }

    bool consider(const TriangleBlock& block, std::size_t lane, const Sifted& sifted) noexcept {
        const float first = sifted.first[lane];
        const float last = sifted.last[lane];
        const bool is_certain = (sifted.certain >> lane & 1U) != 0;
        if (is_certain && (first > last_ || last < ray_.t_min)) return false;
        if (is_certain && last < first_ && first >= ray_.t_min) {
            keep(block, lane, first, last);
        } else if (block_ == nullptr || block.id[lane] != block_->id[lane_]) {
            consider_decided(block, lane);
        }
        return false;
    }

    // Returns false if nothing is hit.
    bool finish(Hit& hit) noexcept {
        if (block_ == nullptr) return false;
        settle(hit);
        return true;
    }

private:
    // Decides in double precision. Of equally close hits the lowest id wins.
    void consider_decided(const TriangleBlock& block, std::size_t lane) noexcept {
        Hit hit;
        if (first_ < last_) settle(hit);
        if (!decide(block, lane, ray_, sheared_.axes, last_, hit)) return;
        const bool is_tie = block_ != nullptr && hit.t == last_;
        if (!is_tie || hit.prim < block_->id[lane_]) keep(block, lane, hit.t, hit.t);
    }

    void settle(Hit& hit) noexcept {
        decide(*block_, lane_, ray_, sheared_.axes, ray_.t_max, hit);
        first_ = last_ = hit.t;
    }

    void keep(const TriangleBlock& block, std::size_t lane, float first, float last) noexcept {
        block_ = &block;
        lane_ = lane;
        first_ = first;
        last_ = last;
    }

    const Ray& ray_;
    const ShearedRay& sheared_;
    // The closest hit so far, with t in [first_, last_].
    const TriangleBlock* block_ = nullptr;
    std::size_t lane_ = 0;
    float first_;
    float last_;
};

// Collects the first hits after a given one, in order of t, then of id, each once.
class FirstKHitsQuery {
public:
    static constexpr bool nearest_first = true;

    FirstKHitsQuery(const Ray& ray, const ShearedRay& sheared, std::span<Hit> hits,
                    const Hit* after) noexcept
        : ray_(ray), sheared_(sheared), list_(hits, after) {}

    [[nodiscard]] float first() const noexcept {
        return first_of(std::max(ray_.t_min, list_.first_distance()));
    }

    [[nodiscard]] float limit() const noexcept { return above(farthest()); }

    bool consider(const TriangleBlock& block, std::size_t lane, const Sifted& /*sifted*/) noexcept {
        Hit hit;
        if (decide(block, lane, ray_, sheared_.axes, farthest(), hit)) list_.insert(hit);
        return false;
    }

    [[nodiscard]] std::size_t count() const noexcept { return list_.size(); }

private:
    [[nodiscard]] float farthest() const noexcept {
        return list_.is_full() ? list_.last_distance() : ray_.t_max;
    }

    const Ray& ray_;
    const ShearedRay& sheared_;
    HitList list_;
};

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

COPPICE_SIMD_END

#endif
