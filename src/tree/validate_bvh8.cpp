// Checks an 8-wide tree in two steps. Its shape. Its contents: boxes are nested, and every block is
// in one leaf and holds the corners of existing triangles. For each triangle, six points (corners
// and edge midpoints) must lie in the boxes of leaves that refer to it. Points are checked rather
// than boxes, because a leaf may hold only a part of a triangle.

#include "coppice/tree/validate.h"

#include "tree/issue_list.h"
#include "tree/shape.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace coppice::inline v0 {
namespace {

// Enlarges a box by the rounding error that a clipped box may have.
Aabb padded(const Aabb& box) {
    Aabb padded = box;
    for (const Axis axis : all_axes) {
        const auto slack = static_cast<float>(1e-6 * box.extent(axis)) +
                           4.0F * std::numeric_limits<float>::denorm_min() +
                           1e-6F * std::max(std::abs(box.lower[axis]), std::abs(box.upper[axis]));
        padded.lower[axis] -= slack;
        padded.upper[axis] += slack;
    }
    return padded;
}

constexpr std::size_t point_count = 6;

std::array<Vec3f, point_count> points_of(const Triangle& triangle) {
    const auto middle = [](const Vec3f& a, const Vec3f& b) { return 0.5F * a + 0.5F * b; };
    const auto& [a, b, c] = triangle;
    return {a, b, c, middle(a, b), middle(b, c), middle(c, a)};
}

class Bvh8Validator {
public:
    Bvh8Validator(const Bvh8& tree, TriangleMeshView mesh, std::size_t limit)
        : tree_(tree),
          mesh_(mesh),
          is_block_met_(tree.blocks().size(), false),
          found_points_(mesh.size(), 0),
          findings_(limit) {}

    std::vector<ValidationIssue> run() {
        check_shape(tree_, findings_);
        if (!findings_.is_empty()) return std::move(findings_).take();
        visit(0, tree_.bounds());
        report_unmet_block();
        for (std::uint32_t id = 0; id < mesh_.size(); ++id) {
            if (found_points_[id] == (1U << point_count) - 1) continue;
            findings_.report(ValidationIssueKind::lost_primitive, id,
                             "{} of 6 points of triangle {} are in no leaf",
                             static_cast<int>(point_count) - std::popcount(found_points_[id]), id);
        }
        return std::move(findings_).take();
    }

private:
    void report_unmet_block() {
        const auto unmet = std::find(is_block_met_.begin(), is_block_met_.end(), false);
        if (unmet == is_block_met_.end()) return;
        const auto at = static_cast<std::uint64_t>(unmet - is_block_met_.begin());
        findings_.report(ValidationIssueKind::unreachable_reference, at, "block {} is in no leaf",
                         at);
    }

    void visit(std::uint32_t index, const Aabb& box) {
        const Bvh8Node& node = tree_.nodes()[index];
        for (std::size_t slot = 0; slot < bvh8_width; ++slot) {
            const Bvh8Child child = node.child[slot];
            if (child.is_empty()) continue;
            const Aabb child_box = node.child_box(slot);
            if (child_box.is_empty() || intersection(child_box, box) != child_box) {
                findings_.report(ValidationIssueKind::box_outside, index,
                                 "child {} of node {} extends beyond the node's box", slot, index);
            }
            if (child.is_leaf()) {
                check_leaf(index, child, padded(child_box));
            } else {
                visit(child.node(), child_box);
            }
        }
    }

    void check_leaf(std::uint32_t node, Bvh8Child leaf, const Aabb& box) {
        const std::uint32_t end = leaf.first_block() + leaf.block_count();
        for (std::uint32_t at = leaf.first_block(); at < end; ++at) {
            if (is_block_met_[at]) {
                findings_.report(ValidationIssueKind::bad_range, node, "block {} is in two leaves",
                                 at);
            }
            is_block_met_[at] = true;
            check_block(at, box);
        }
    }

    void check_block(std::uint32_t at, const Aabb& box) {
        const TriangleBlock& block = tree_.blocks()[at];
        for (std::size_t lane = 0; lane < bvh8_width; ++lane) {
            const std::uint32_t id = block.id[lane];
            if (id == TriangleBlock::no_triangle) continue;
            if (id >= mesh_.size()) {
                findings_.report(ValidationIssueKind::bad_reference, at,
                                 "block {} refers to triangle {}, but there are {}", at, id,
                                 mesh_.size());
                continue;
            }
            if (block.triangle(lane) != mesh_.triangle(id)) {
                findings_.report(ValidationIssueKind::wrong_corners, at,
                                 "block {} has corners that differ from those of triangle {}", at,
                                 id);
            }
            const auto points = points_of(mesh_.triangle(id));
            for (std::size_t point = 0; point < point_count; ++point) {
                if (box.contains(points[point])) found_points_[id] |= 1U << point;
            }
        }
    }

    const Bvh8& tree_;
    TriangleMeshView mesh_;
    std::vector<bool> is_block_met_;
    std::vector<unsigned> found_points_;  // six bits per triangle, one per point found
    IssueList findings_;
};

}  // namespace

std::vector<ValidationIssue> validate(const Bvh8& tree, TriangleMeshView mesh, std::size_t limit) {
    mesh.require_valid(0, mesh.size());
    return Bvh8Validator(tree, mesh, limit).run();
}

}  // namespace coppice::inline v0
