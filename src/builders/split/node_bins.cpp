#include "builders/split/node_bins.h"

#include "coppice/base/parallel.h"

#include "builders/chunk_sizes.h"
#include "builders/kernels/kd_kernels.h"
#include "builders/split/evaluate_plane.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace coppice::inline v0 {

std::optional<BinGrid> bin_grid(const Aabb& box) noexcept {
    BinGrid grid{box.lower, {}};
    for (const Axis axis : all_axes) {
        const double extent = box.extent(axis);
        if (extent == 0.0) continue;  // everything is in the first bin
        if (extent < 1e-30 || extent > 1e30) return std::nullopt;
        grid.bins_per_unit[axis] = static_cast<float>(static_cast<double>(bin_count) / extent);
    }
    return grid;
}

NodeBins bin_node(std::span<const PrimRef> prim_refs, const BinGrid& grid, Isa isa) {
    const KdKernels& kernels = kd_kernels_for(isa);
    NodeBins sum;
    if (prim_refs.size() <= prim_refs_per_task) {
        kernels.bin_ends(prim_refs, grid, sum);
        return sum;
    }
    std::vector<NodeBins> chunks((prim_refs.size() + prim_refs_per_task - 1) / prim_refs_per_task);
    parallel_for_chunks(prim_refs.size(), prim_refs_per_task,
                        [&](std::size_t begin, std::size_t end) {
                            kernels.bin_ends(prim_refs.subspan(begin, end - begin), grid,
                                             chunks[begin / prim_refs_per_task]);
                        });
    for (const NodeBins& chunk : chunks) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const AxisBins& from = chunk[axis];
            for (std::size_t bin = 0; bin < bin_count; ++bin) {
                sum[axis].add_start(bin, from.first_start[bin], from.starts[bin]);
                sum[axis].add_end(bin, from.last_end[bin], from.ends[bin]);
            }
        }
    }
    return sum;
}

std::optional<BinBoundary> best_boundary(const SplitQuery& query, Axis axis, const AxisBins& bins,
                                         double weight) {
    std::optional<BinBoundary> best;
    const PlaneEvaluator evaluator(query.box, axis, query.cost);
    const double width = query.box.extent(axis) / static_cast<double>(bin_count);
    SplitCounts counts{0.0, weight, 0.0};
    for (std::size_t bin = 1; bin < bin_count; ++bin) {
        counts.below += bins.starts[bin - 1];
        counts.above -= bins.ends[bin - 1];
        const auto position =
            static_cast<float>(query.box.lower[axis] + static_cast<double>(bin) * width);
        if (!evaluator.is_inside(position)) continue;
        const double cost = evaluator.evaluate(position, counts).cost;
        if (!best || cost < best->cost) best = {{axis, position + 0.0F}, bin, cost};
    }
    return best;
}

double weight_in(const AxisBins& bins) noexcept {
    return std::accumulate(bins.starts.begin(), bins.starts.end(), 0.0);
}

BinnedPlane best_end(const AxisBins& bins, SplitCounts before, const PlaneEvaluator& evaluator) {
    std::array<float, bin_count + 1> next_start;
    next_start[bin_count] = Aabb::infinity;
    SplitCounts counts = before;
    for (std::size_t bin = bin_count; bin-- > 0;) {
        next_start[bin] = std::min(bins.first_start[bin], next_start[bin + 1]);
        counts.above += bins.ends[bin];
    }
    BinnedPlane best;
    float last_end = -Aabb::infinity;
    for (std::size_t bin = 0; bin <= bin_count; ++bin) {
        const bool has_start = evaluator.is_inside(next_start[bin]);
        const bool has_end = evaluator.is_inside(last_end);
        // If more weight reaches above than below, the cost falls towards the next start.
        const bool takes_start = has_start && (!has_end || counts.below <= counts.above);
        if (takes_start || has_end) {
            const float position = (takes_start ? next_start[bin] : last_end) + 0.0F;
            SplitCandidate split = evaluator.evaluate(position, counts);
            split.planar_side = takes_start ? PlanarSide::above : PlanarSide::below;
            if (split.cost < best.split.cost) best = {split, bin};
        }
        if (bin == bin_count) break;
        counts.below += bins.starts[bin];
        counts.above -= bins.ends[bin];
        last_end = std::max(last_end, bins.last_end[bin]);
    }
    return best;
}

}  // namespace coppice::inline v0
