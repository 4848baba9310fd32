// A split rule of one's own: the plane through the middle of the primitives' boxes, not of the
// node.
#include <coppice/builders/split_finder.h>
#include <coppice/coppice.h>

#include <cstdio>
#include <memory>

namespace {

class MiddleOfContents final : public coppice::SplitFinder {
public:
    [[nodiscard]] std::optional<coppice::SplitCandidate> find(
        const coppice::SplitQuery& query) const override {
        coppice::Aabb contents;
        for (const coppice::PrimRef& prim_ref : query.prim_refs) {
            contents.grow(prim_ref.box);
        }
        const coppice::Axis axis = contents.longest_axis();
        const coppice::SplitPlane plane{axis,
                                        0.5F * contents.lower[axis] + 0.5F * contents.upper[axis]};
        const bool is_inside =
            plane.position > query.box.lower[axis] && plane.position < query.box.upper[axis];
        if (!is_inside) return std::nullopt;
        return cost_of(query, plane);
    }

private:
    static coppice::SplitCandidate cost_of(const coppice::SplitQuery& query,
                                           coppice::SplitPlane plane) {
        double below = 0.0;
        double above = 0.0;
        for (const coppice::PrimRef& prim_ref : query.prim_refs) {
            // What lies in the plane goes below it.
            if (prim_ref.box.lower[plane.axis] < plane.position ||
                prim_ref.box.upper[plane.axis] == plane.position) {
                below += prim_ref.weight;
            }
            if (prim_ref.box.upper[plane.axis] > plane.position) above += prim_ref.weight;
        }
        const double area = query.box.surface_area();
        return {
            plane, coppice::PlanarSide::below,
            query.cost.split_cost(coppice::below(query.box, plane).surface_area() / area, below,
                                  coppice::above(query.box, plane).surface_area() / area, above)};
    }
};

}  // namespace

int main() {
    const coppice::TriangleMesh mesh = coppice::load_mesh("bunny.obj");
    coppice::KdOptions options{.split = {.rule = "midpoint"}};
    const auto midpoint = coppice::build_kd_tree(mesh.view(), options);
    options.split = {.custom_rule = std::make_shared<const MiddleOfContents>()};
    const auto mine = coppice::build_kd_tree(mesh.view(), options);

    std::printf("middle of the node: cost %.1f\n", midpoint.report.statistics.sah_cost);
    std::printf("middle of its contents: cost %.1f\n", mine.report.statistics.sah_cost);
}
