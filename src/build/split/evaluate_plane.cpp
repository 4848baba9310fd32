#include "build/split/evaluate_plane.h"

#include "build/partition.h"

namespace coppice {

double weight_of(std::span<const Fragment> fragments) noexcept {
    double weight = 0.0;
    for (const Fragment& fragment : fragments) {
        weight += fragment.weight;
    }
    return weight;
}

Split evaluate_plane(const SplitQuery& query, Plane plane) noexcept {
    SplitCounts counts;
    for (const Fragment& fragment : query.fragments) {
        switch (relation_to(fragment.box, plane)) {
            case PlaneRelation::below:
                counts.below += fragment.weight;
                break;
            case PlaneRelation::above:
                counts.above += fragment.weight;
                break;
            case PlaneRelation::in_plane:
                counts.in_plane += fragment.weight;
                break;
            case PlaneRelation::across:
                counts.below += fragment.weight;
                counts.above += fragment.weight;
                break;
        }
    }
    return PlaneEvaluator(query.box, plane.axis, query.cost).evaluate(plane.position, counts);
}

}  // namespace coppice
