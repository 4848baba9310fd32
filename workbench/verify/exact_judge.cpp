// Candidates are all triangles in leaves whose boxes the line meets, from the ray's start to its
// end: a plain walk, in double, that shares nothing with the traversals. They are looked at by the
// distance at which the ray enters their boxes until no other can be closer. What may_meet() cannot
// rule out is decided by exact_distance().

#include "verify/exact_judge.h"

#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"

#include "verify/exact_hit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace coppice::lab {

namespace {

struct Candidate {
    double enter;
    std::uint32_t prim;
};

/// Where a ray enters a box, or infinity if it does not. Never too large: distances are off by less
/// than 2^-50 of themselves.
double enter_box(const Ray& ray, const Aabb& box) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto widened = [](double t, double way) { return t + way * 0x1.0p-40 * std::abs(t); };
    double enter = widened(ray.t_min, -1.0);
    double exit = widened(ray.t_max, 1.0);
    if (box.is_empty()) return infinity;
    for (const Axis axis : all_axes) {
        const double origin = ray.origin[axis];
        const double direction = ray.direction[axis];
        if (direction == 0.0) {
            if (origin < box.lower[axis] || origin > box.upper[axis]) return infinity;
            continue;
        }
        const double a = (box.lower[axis] - origin) / direction;
        const double b = (box.upper[axis] - origin) / direction;
        enter = std::max(enter, widened(std::min(a, b), -1.0));
        exit = std::min(exit, widened(std::max(a, b), 1.0));
    }
    return enter <= exit ? enter : infinity;
}

void add_leaf(const Bvh8& tree, Bvh8Child leaf, const Ray& ray, std::vector<Candidate>& found) {
    for (const TriangleBlock& block :
         tree.blocks().subspan(leaf.first_block(), leaf.block_count())) {
        for (std::size_t lane = 0; lane < bvh8_width; ++lane) {
            if (block.id[lane] == TriangleBlock::no_triangle) break;
            const double enter = enter_box(ray, triangle_bounds(block.triangle(lane)));
            if (std::isfinite(enter)) found.push_back({enter, block.id[lane]});
        }
    }
}

std::vector<Candidate> find_candidates(const Bvh8& tree, const Ray& ray) {
    std::vector<Candidate> found;
    std::vector<std::uint32_t> waiting{0};
    while (!waiting.empty()) {
        const Bvh8Node& node = tree.nodes()[waiting.back()];
        waiting.pop_back();
        for (std::size_t slot = 0; slot < bvh8_width; ++slot) {
            const Bvh8Child child = node.child[slot];
            if (child.is_empty()) break;
            if (!std::isfinite(enter_box(ray, node.child_box(slot)))) continue;
            if (child.is_leaf()) {
                add_leaf(tree, child, ray, found);
            } else {
                waiting.push_back(child.node());
            }
        }
    }
    return found;
}

}  // namespace

ExactJudge::ExactJudge(TriangleMeshView mesh)
    : mesh_(mesh), tree_(build_bvh8(mesh, find_method("fast").bvh8_options()).tree) {}

std::optional<ExactHit> ExactJudge::closest(const Ray& ray,
                                            std::span<const std::uint32_t> claimed) const {
    if (!is_traceable(ray)) return std::nullopt;
    std::vector<Candidate> candidates = find_candidates(tree_, ray);
    for (const std::uint32_t prim : claimed) {
        candidates.push_back({-std::numeric_limits<double>::infinity(), prim});
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.enter < b.enter; });
    std::optional<ExactHit> best;
    for (const Candidate& candidate : candidates) {
        if (best && candidate.enter > best->t) break;
        const Triangle triangle = mesh_.triangle(candidate.prim);
        if (!may_meet(ray, triangle)) continue;
        const auto t = exact_distance(ray, triangle);
        if (!t || (best && *t >= best->t)) continue;
        const auto rounded = static_cast<float>(*t);
        if (rounded >= ray.t_min && rounded <= ray.t_max) best = {*t, candidate.prim};
    }
    return best;
}

}  // namespace coppice::lab
