#include "builders/split/evaluate_plane.h"

#include "builders/kd/partition.h"

namespace coppice::inline v0 {

double weight_of(std::span<const PrimRef> prim_refs) noexcept {
    double weight = 0.0;
    for (const PrimRef& prim_ref : prim_refs) {
        weight += prim_ref.weight;
    }
    return weight;
}

SplitCandidate evaluate_plane(const SplitQuery& query, SplitPlane plane) noexcept {
    SplitCounts counts;
    for (const PrimRef& prim_ref : query.prim_refs) {
        switch (relation_to(prim_ref.box, plane)) {
            case PlaneRelation::below:
                counts.below += prim_ref.weight;
                break;
            case PlaneRelation::above:
                counts.above += prim_ref.weight;
                break;
            case PlaneRelation::in_plane:
                counts.in_plane += prim_ref.weight;
                break;
            case PlaneRelation::across:
                counts.below += prim_ref.weight;
                counts.above += prim_ref.weight;
                break;
        }
    }
    return PlaneEvaluator(query.box, plane.axis, query.cost).evaluate(plane.position, counts);
}

}  // namespace coppice::inline v0
