// Divides a scene into pieces by a k-d tree over a sample of 16 primitives per piece. Every n-th
// leaf in depth-first order becomes a piece of the probe. Near leaves are alike, so leaves at equal
// distances cover the scene. All primitives then descend to the pieces that they touch and are
// clipped to them. Cost: one descent of a few steps per primitive, in parallel.

#include "builders/probe.h"

#include "coppice/base/parallel.h"
#include "coppice/builders/build_on_sample.h"
#include "coppice/builders/draw_sample.h"

#include "builders/chunk_sizes.h"
#include "builders/kd/partition.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace coppice::inline v0 {
namespace {

constexpr std::uint32_t sampled_per_piece = 16;

KdTree divide(PrimitiveSetView primitives, std::uint32_t piece_count) {
    KdOptions options;
    options.sample.rate =
        std::min(1.0, double{sampled_per_piece} * piece_count / primitives.size());
    options.split.rule = "exact";  // cuts the fewest primitives
    options.split.max_leaf = sampled_per_piece;
    return build_on_sample(primitives, draw_sample(primitives, options.sample), options);
}

Vec3f middle_of(const Aabb& box) {
    return 0.5F * box.lower + 0.5F * box.upper;
}

// Finds the pieces of a probe in the tree that divides a scene, and the parts of primitives in
// them.
class Prober {
public:
    Prober(PrimitiveSetView primitives, std::uint32_t piece_count, std::uint32_t n)
        : primitives_(primitives),
          tree_(divide(primitives, piece_count)),
          piece_of_(tree_.nodes().size()) {
        std::uint32_t leaf_count = 0;
        is_probed_.resize(tree_.nodes().size());
        choose(0, tree_.bounds(), n, leaf_count);
    }

    [[nodiscard]] Probe probe() && {
        std::vector<Found> chunks(primitives_.size() / primitives_per_task + 1);
        parallel_for_chunks(
            primitives_.size(), primitives_per_task, [&](std::size_t begin, std::size_t end) {
                for (auto id = static_cast<std::uint32_t>(begin); id < end; ++id) {
                    const Aabb box = primitives_.bounds(id);
                    find(0, {id, box, middle_of(box)}, chunks[begin / primitives_per_task]);
                }
            });
        Found all;
        for (const Found& chunk : chunks) {
            all.parts.insert(all.parts.end(), chunk.parts.begin(), chunk.parts.end());
            all.centers.insert(all.centers.end(), chunk.centers.begin(), chunk.centers.end());
        }
        return {primitives_, std::move(pieces_), std::move(all.parts), std::move(all.centers)};
    }

private:
    // Makes every n-th leaf a piece. Returns true if there is a piece at or below the node.
    bool choose(std::uint32_t index, const Aabb& box, std::uint32_t n, std::uint32_t& leaf_count) {
        const KdNode& node = tree_.nodes()[index];
        if (!node.is_leaf()) {
            const bool is_below =
                choose(node.lower_child(), below(box, node.plane()), n, leaf_count);
            const bool is_above =
                choose(node.upper_child(), above(box, node.plane()), n, leaf_count);
            is_probed_[index] = is_below || is_above;
        } else if (leaf_count++ % n == n / 2) {
            piece_of_[index] = static_cast<std::uint32_t>(pieces_.size());
            pieces_.push_back(box);
            is_probed_[index] = true;
        }
        return is_probed_[index];
    }

    struct Found {
        std::vector<ProbePart> parts;
        std::vector<ProbeCenter> centers;
    };

    struct Query {
        std::uint32_t id;
        Aabb box;
        Vec3f middle;
        bool has_middle = true;  // the middle is in the node; one in a plane is above it
    };

    // Adds the parts of a primitive that are in the pieces at or below a node.
    void find(std::uint32_t index, Query query, Found& found) const {
        if (!is_probed_[index]) return;
        const KdNode& node = tree_.nodes()[index];
        if (node.is_leaf()) {
            find_in_piece(piece_of_[index], query, found);
            return;
        }
        const SplitPlane plane = node.plane();
        const PlaneRelation relation = relation_to(query.box, plane);
        const bool has_middle = query.has_middle;
        const bool is_middle_below = query.middle[plane.axis] < plane.position;
        if (relation == PlaneRelation::below || relation == PlaneRelation::across) {
            query.has_middle = has_middle && is_middle_below;
            find(node.lower_child(), query, found);
        }
        if (relation != PlaneRelation::below) {
            query.has_middle = has_middle && !is_middle_below;
            find(node.upper_child(), query, found);
        }
    }

    void find_in_piece(std::uint32_t piece, const Query& query, Found& found) const {
        if (query.has_middle) found.centers.push_back({query.id, piece});
        const Aabb part = primitives_.clipped_bounds(query.id, pieces_[piece]);
        if (!part.is_empty()) found.parts.push_back({query.id, part, piece});
    }

    PrimitiveSetView primitives_;
    KdTree tree_;
    std::vector<std::uint32_t> piece_of_;
    std::vector<bool> is_probed_;
    std::vector<Aabb> pieces_;
};

}  // namespace

Probe Probe::thinned(std::uint32_t n) const {
    const auto is_kept = [n](const auto& part) { return part.piece % n == 0; };
    std::vector<ProbePart> parts;
    std::copy_if(parts_.begin(), parts_.end(), std::back_inserter(parts), is_kept);
    std::vector<ProbeCenter> centers;
    std::copy_if(centers_.begin(), centers_.end(), std::back_inserter(centers), is_kept);
    return {primitives_, pieces_, std::move(parts), std::move(centers)};
}

Probe take_probe(PrimitiveSetView primitives, std::uint32_t piece_count, std::uint32_t n) {
    return Prober(primitives, piece_count, n).probe();
}

}  // namespace coppice::inline v0
