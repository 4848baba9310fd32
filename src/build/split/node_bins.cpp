#include "build/split/node_bins.h"

#include "coppice/base/parallel.h"

#include "build/split/evaluate_plane.h"

#include <vector>

namespace coppice {

std::optional<BinGrid> bin_grid(const Aabb& box) noexcept {
    BinGrid grid{box.lower, {}};
    for (const Axis axis : all_axes) {
        const double extent = box.extent(axis);
        if (extent == 0.0) continue;  // all in the first bin
        if (extent < 1e-30 || extent > 1e30) return std::nullopt;
        grid.bins_per_unit[axis] = static_cast<float>(static_cast<double>(bin_count) / extent);
    }
    return grid;
}

NodeBins bin_node(std::span<const Fragment> fragments, const BinGrid& grid) {
    constexpr std::size_t chunk_size = 32768;
    NodeBins sum;
    if (fragments.size() <= chunk_size) {
        bin_ends(fragments, grid, sum);
        return sum;
    }
    std::vector<NodeBins> chunks((fragments.size() + chunk_size - 1) / chunk_size);
    parallel_for_chunks(fragments.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        bin_ends(fragments.subspan(begin, end - begin), grid, chunks[begin / chunk_size]);
    });
    for (const NodeBins& chunk : chunks) {
        sum.extent.grow(chunk.extent);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t bin = 0; bin < bin_count; ++bin) {
                sum.axes[axis].starts[bin] += chunk.axes[axis].starts[bin];
                sum.axes[axis].ends[bin] += chunk.axes[axis].ends[bin];
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

}  // namespace coppice
