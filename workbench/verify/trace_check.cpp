// Two tracers with different arithmetic do not agree to the bit. On an edge they may hit different
// triangles, and close to one they may disagree on whether there is a hit. The same distance with
// another triangle counts as a tie. Exact arithmetic decides every other difference, ray by ray.

#include "verify/trace_check.h"

#include "coppice/base/error.h"
#include "coppice/base/named.h"
#include "coppice/base/parallel.h"
#include "coppice/trace/brute_force.h"

#include "tracers/hit_agreement.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::lab {

namespace {

constexpr std::string_view embree_name = "embree-robust";

/// Whether an answer is the truth, for shadow rays as to whether there is a hit.
bool is_right(const Hit& answer, const std::optional<ExactHit>& exact, RayKind kind) noexcept {
    if (answer.is_hit() != exact.has_value()) return false;
    return !exact || kind == RayKind::shadow || is_same_distance(answer.t, exact->t);
}

bool has_embree() {
    const auto peers = peer_registry();
    return std::any_of(peers.begin(), peers.end(),
                       [](const Peer& peer) { return peer.name == embree_name; });
}

}  // namespace

void HitCheck::require(TraceCheck check) {
    if (check != TraceCheck::embree || has_embree()) return;
    throw Error(ErrorCode::invalid_argument,
                "this program was built without Embree; compare hits with brute force, or install "
                "libembree-dev and build it again");
}

HitCheck::HitCheck(TriangleMeshView mesh, TraceCheck check, int threads)
    : mesh_(mesh), check_(check), judge_(mesh) {
    if (check != TraceCheck::embree) return;
    const int count = threads == 0 ? hardware_thread_count() : threads;
    embree_ = find_named(peer_registry(), embree_name, "peer").make(count);
    static_cast<void>(embree_->build(mesh, false));
}

TraceComparison HitCheck::compare(const TracedTree& tree, RayKind kind, std::span<const Ray> rays,
                                  std::span<const Hit> hits) const {
    const std::vector<Hit> expected = trace_reference(kind, rays);
    TraceComparison comparison;
    std::vector<TraceDifference> differences;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Hit& ours = hits[i];
        const Hit& theirs = expected[i];
        if (is_same_distance(ours.t, theirs.t)) {
            comparison.ties += ours.is_hit() && ours.prim != theirs.prim ? 1 : 0;
            continue;
        }
        ++(ours.is_hit() == theirs.is_hit() ? comparison.distance : comparison.hit_miss);
        differences.push_back({.ray = rays[i], .index = i, .ours = ours, .reference = theirs});
    }
    parallel_for_chunks(differences.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            judge(tree, kind, differences[i]);
        }
    });
    for (const TraceDifference& difference : differences) {
        comparison.ours_right += difference.is_ours_right ? 1 : 0;
        comparison.ours_wrong += difference.is_ours_right ? 0 : 1;
        comparison.reference_right += difference.is_reference_right ? 1 : 0;
    }
    // Those that we are wrong about first.
    std::stable_partition(differences.begin(), differences.end(),
                          [](const TraceDifference& each) { return !each.is_ours_right; });
    differences.resize(std::min(differences.size(), example_count));
    comparison.examples = std::move(differences);
    // Brute force tests triangles as we do: what is not the same is a fault of the traversal.
    if (check_ == TraceCheck::brute) {
        comparison.ours_wrong = comparison.ties + comparison.hit_miss + comparison.distance;
    }
    return comparison;
}

std::vector<Hit> HitCheck::trace_reference(RayKind kind, std::span<const Ray> rays) const {
    std::vector<Hit> hits(rays.size());
    constexpr std::size_t chunk_size = 1024;
    parallel_for_chunks(rays.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        const auto chunk = rays.subspan(begin, end - begin);
        if (check_ == TraceCheck::embree && kind == RayKind::shadow) {
            std::array<std::uint8_t, chunk_size> flags{};
            embree_->occluded(chunk, std::span(flags).first(chunk.size()), Queries::single);
            for (std::size_t i = begin; i < end; ++i) {
                if (flags[i - begin] != 0) hits[i].t = 0.0F;
            }
            return;
        }
        for (std::size_t i = begin; i < end; ++i) {
            hits[i] = reference_hit(rays[i]);
            if (kind == RayKind::shadow && hits[i].is_hit()) hits[i] = {.t = 0.0F};
        }
    });
    return hits;
}

Hit HitCheck::reference_hit(const Ray& ray) const {
    if (check_ == TraceCheck::brute) return brute_force_intersect(mesh_, ray).value_or(Hit{});
    Hit hit;
    embree_->intersect(std::span(&ray, 1), std::span(&hit, 1), Queries::single);
    return hit;
}

void HitCheck::judge(const TracedTree& tree, RayKind kind, TraceDifference& difference) const {
    const Ray& ray = difference.ray;
    std::vector<std::uint32_t> claimed;
    const auto claim = [&](const Hit& hit) {
        if (hit.is_hit()) claimed.push_back(hit.prim);
    };
    // Any-hit queries do not tell what they hit: closest-hit queries do, if they agree with them.
    claim(kind == RayKind::shadow ? tree.intersect(ray).value_or(Hit{}) : difference.ours);
    claim(kind == RayKind::shadow ? reference_hit(ray) : difference.reference);
    difference.exact = judge_.closest(ray, claimed);
    difference.is_ours_right = is_right(difference.ours, difference.exact, kind);
    difference.is_reference_right = is_right(difference.reference, difference.exact, kind);
}

}  // namespace coppice::lab
