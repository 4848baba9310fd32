// Checks a tree in three steps. Its shape: each node is reached once. Its references: each is in
// one leaf, sorted, and of an existing primitive. Its contents: all primitives descend the tree,
// filtered only by their boxes. This does not use the code that built the tree.
//
// The third step has a tolerance around split planes. A leaf must refer to each primitive that
// reaches into it by more than the tolerance, and may refer to any whose box comes within the
// tolerance of it. The tolerance is a share of the node's size, and at least the rounding error of
// the primitive's coordinates.

#include "coppice/tree/validate.h"

#include "coppice/tree/walk.h"

#include "base/free_memory.h"
#include "tree/issue_list.h"
#include "tree/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace coppice::inline v0 {
namespace {

// A node on the walk. Its inner box is the cell reduced by the tolerance at every face that is a
// split plane; a primitive that enters it certainly belongs to the node.
struct Place {
    std::uint32_t index;
    Aabb box;
    Aabb inside;
};

float tolerance_at(const Aabb& box, SplitPlane plane) {
    const double scale =
        std::max(box.extent(plane.axis), std::abs(static_cast<double>(plane.position)));
    // For denormal sizes, rounding is a matter of the smallest float.
    return static_cast<float>(1e-6 * scale) + 4.0F * std::numeric_limits<float>::denorm_min();
}

// The part of a place in which clipping finds a primitive with these bounds only if it is really
// there. Conservative clipping may find a primitive that stays outside by the rounding error of its
// coordinates.
Aabb part_reached_for_certain(const Place& at, const Aabb& primitive) {
    Aabb part = at.inside;
    for (const Axis axis : all_axes) {
        const float rounding =
            0x1.0p-44F * std::max(std::abs(primitive.lower[axis]), std::abs(primitive.upper[axis]));
        if (part.lower[axis] != at.box.lower[axis]) part.lower[axis] += rounding;
        if (part.upper[axis] != at.box.upper[axis]) part.upper[axis] -= rounding;
    }
    return part;
}

class Validator {
public:
    Validator(const KdTree& tree, PrimitiveSetView primitives, std::size_t limit)
        : tree_(tree),
          primitives_(primitives),
          is_referenced_(primitives.size(), false),
          findings_(limit) {}

    std::vector<ValidationIssue> run() {
        check_shape(tree_, findings_);
        if (findings_.is_empty() && check_references()) check_contents();
        return std::move(findings_).take();
    }

private:
    // Checks that the leaves have disjoint ranges of references which cover the array, with
    // existing ids in ascending order.
    bool check_references() {
        const std::size_t count = tree_.references().size();
        std::vector<bool> is_owned(count, false);
        for (std::size_t i = 0; i < tree_.nodes().size(); ++i) {
            const KdNode& node = tree_.nodes()[i];
            if (!node.is_leaf() || node.reference_count() == 0) continue;
            const std::size_t first = node.first_reference();
            const std::size_t end = first + node.reference_count();
            const auto owned = is_owned.begin();
            const auto own_begin = owned + static_cast<std::ptrdiff_t>(first);
            const auto own_end = owned + static_cast<std::ptrdiff_t>(end);
            if (std::find(own_begin, own_end, true) != own_end) {
                findings_.report(ValidationIssueKind::bad_range, i,
                                 "leaf {} has references {} to {}, which overlap another leaf's", i,
                                 first, end);
                continue;
            }
            std::fill(own_begin, own_end, true);
            check_ids(i, node);
        }
        const auto unowned = std::find(is_owned.begin(), is_owned.end(), false);
        if (unowned != is_owned.end()) {
            const auto at = static_cast<std::uint64_t>(unowned - is_owned.begin());
            findings_.report(ValidationIssueKind::unreachable_reference, at,
                             "reference {} is in no leaf", at);
        }
        return findings_.is_empty();
    }

    void check_ids(std::size_t index, const KdNode& leaf) {
        const auto ids = tree_.references(leaf);
        for (std::size_t k = 0; k < ids.size(); ++k) {
            if (ids[k] >= primitives_.size()) {
                findings_.report(ValidationIssueKind::bad_reference, index,
                                 "leaf {} refers to primitive {}, but there are {}", index, ids[k],
                                 primitives_.size());
            } else {
                is_referenced_[ids[k]] = true;
            }
            if (k > 0 && ids[k - 1] >= ids[k]) {
                findings_.report(ValidationIssueKind::unsorted_references, index,
                                 "leaf {} has {} before {}", index, ids[k - 1], ids[k]);
            }
        }
    }

    void check_contents() {
        std::vector<std::uint32_t> all(primitives_.size());
        for (std::uint32_t id = 0; id < primitives_.size(); ++id) {
            all[id] = id;
            if (!is_referenced_[id]) {
                findings_.report(ValidationIssueKind::lost_primitive, id,
                                 "primitive {} is in no leaf", id);
            }
            const Aabb box = primitives_.bounds(id);
            if (intersection(box, tree_.bounds()) != box) {
                findings_.report(ValidationIssueKind::bounds_too_small, id,
                                 "primitive {} extends beyond the tree's box", id);
            }
        }
        descend({0, tree_.bounds(), tree_.bounds()}, std::move(all));
    }

    // Descends to a node. `candidates` are the primitives whose boxes reach into it.
    void descend(const Place& at, std::vector<std::uint32_t> candidates) {
        if (findings_.is_full()) return;
        const KdNode& node = tree_.nodes()[at.index];
        if (node.is_leaf()) {
            check_leaf(at, candidates);
            return;
        }
        const SplitPlane plane = node.plane();
        if (!(plane.position > at.box.lower[plane.axis] &&
              plane.position < at.box.upper[plane.axis])) {
            findings_.report(ValidationIssueKind::plane_outside, at.index,
                             "node {} is split at {}, outside [{}, {}]", at.index, plane.position,
                             at.box.lower[plane.axis], at.box.upper[plane.axis]);
            return;
        }
        const float tolerance = tolerance_at(at.box, plane);
        const SplitPlane lower_plane{plane.axis, plane.position - tolerance};
        const SplitPlane upper_plane{plane.axis, plane.position + tolerance};
        const Place lower{node.lower_child(), below(at.box, plane), below(at.inside, lower_plane)};
        const Place upper{node.upper_child(), above(at.box, plane), above(at.inside, upper_plane)};
        auto lower_candidates = reaching(candidates, lower.inside);
        auto upper_candidates = reaching(candidates, upper.inside);
        free_memory(candidates);
        descend(lower, std::move(lower_candidates));
        descend(upper, std::move(upper_candidates));
    }

    [[nodiscard]] std::vector<std::uint32_t> reaching(const std::vector<std::uint32_t>& ids,
                                                      const Aabb& box) const {
        std::vector<std::uint32_t> inside;
        std::copy_if(ids.begin(), ids.end(), std::back_inserter(inside),
                     [&](std::uint32_t id) { return primitives_.bounds(id).overlaps(box); });
        return inside;
    }

    void check_leaf(const Place& at, const std::vector<std::uint32_t>& candidates) {
        const auto ids = tree_.references(tree_.nodes()[at.index]);
        for (const std::uint32_t id : candidates) {
            if (std::binary_search(ids.begin(), ids.end(), id)) continue;
            const Aabb part = part_reached_for_certain(at, primitives_.bounds(id));
            if (part.is_empty() || primitives_.clipped_bounds(id, part).is_empty()) continue;
            findings_.report(ValidationIssueKind::missing_reference, at.index,
                             "leaf {} lacks primitive {}", at.index, id);
        }
        for (const std::uint32_t id : ids) {
            if (!primitives_.bounds(id).overlaps(at.box)) {
                findings_.report(ValidationIssueKind::stray_reference, at.index,
                                 "leaf {} refers to primitive {}, which is not in its box",
                                 at.index, id);
            }
        }
    }

    const KdTree& tree_;
    PrimitiveSetView primitives_;
    std::vector<bool> is_referenced_;
    IssueList findings_;
};

}  // namespace

const char* name_of(ValidationIssueKind kind) noexcept {
    switch (kind) {
        case ValidationIssueKind::bad_child:
            return "bad_child";
        case ValidationIssueKind::unreachable_node:
            return "unreachable_node";
        case ValidationIssueKind::too_deep:
            return "too_deep";
        case ValidationIssueKind::plane_outside:
            return "plane_outside";
        case ValidationIssueKind::bad_range:
            return "bad_range";
        case ValidationIssueKind::unreachable_reference:
            return "unreachable_reference";
        case ValidationIssueKind::bad_reference:
            return "bad_reference";
        case ValidationIssueKind::unsorted_references:
            return "unsorted_references";
        case ValidationIssueKind::missing_reference:
            return "missing_reference";
        case ValidationIssueKind::stray_reference:
            return "stray_reference";
        case ValidationIssueKind::lost_primitive:
            return "lost_primitive";
        case ValidationIssueKind::bounds_too_small:
            return "bounds_too_small";
        case ValidationIssueKind::box_outside:
            return "box_outside";
        case ValidationIssueKind::wrong_corners:
            return "wrong_corners";
        case ValidationIssueKind::bad_gap:
            return "bad_gap";
    }
    return "unknown";
}

std::vector<ValidationIssue> validate(const KdTree& tree, PrimitiveSetView primitives,
                                      std::size_t limit) {
    primitives.require_valid(0, primitives.size());
    return Validator(tree, primitives, limit).run();
}

}  // namespace coppice::inline v0
